// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/settings/key_table.h"

#include <QObject>

#include <functional>

class QAction;

namespace ui {

class MainWindow;

/// The keys of a window's commands: the standard ones, or those that the person gave, which are
/// remembered. All that shows keys reads the actions.
class CommandKeys : public QObject {
    Q_OBJECT

public:
    /// To be made once, when the window has all its commands. Belongs to the window.
    explicit CommandKeys(MainWindow& window);
    static CommandKeys& of(MainWindow& window);

    const app::KeyTable& table() const { return table_; }
    void reread(); ///< the settings, which another window may have changed
    /// `KeyNews` tells of it.
    void change(const std::function<void(app::KeyTable&)>& step);
    /// Says once, after what is being opened, that keys in the settings were ignored, if any were:
    /// a drawing that is opened takes away the messages before it.
    void tellIgnored();

private:
    void apply();

    MainWindow& window_;
    std::vector<QAction*> actions_; ///< of the table's commands; null: no action
    app::KeyTable table_;
    QMetaObject::Connection afterLoading_;
};

} // namespace ui

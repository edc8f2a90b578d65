// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace ui {

/// Gives an open menu all keys. Without it a letter would be the shortcut of a tool, because the
/// canvas behind the menu keeps the focus, and the entry with this letter could not be chosen.
class MenuKeys : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* receiver, QEvent* event) override;
};

} // namespace ui

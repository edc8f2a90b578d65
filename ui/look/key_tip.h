// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/keys_in_use.h"

#include <QAction>
#include <QWidget>

#include <functional>

namespace ui {

/// Signals that commands have other keys, which tooltips and labels name (`app::withKeys`).
class KeyNews : public QObject {
    Q_OBJECT

public:
    static KeyNews& get(); ///< the only one
    void tell(const app::KeysInUse& keys);

signals:
    void changed();
};

/// Calls `refresh` now, and each time that commands have other keys, as long as `widget` exists.
void followKeys(QObject& widget, const std::function<void()>& refresh);

/// A tooltip that names keys: "Show the grid ({grid})".
void setKeyTip(QWidget& widget, const QString& text);

/// A name with the first key of an action, if it has one: "Fit drawing (Shift+1)".
QString nameWithKey(const QString& name, const QAction& action);

} // namespace ui

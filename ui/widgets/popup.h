// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

namespace ui {

/// A small window below a button. Esc and a click elsewhere close it.
class Popup : public QFrame {
    Q_OBJECT

public:
    Popup(const QString& name, QWidget* parent);

    /// Shows it below a widget, or above it if there is no room; always on the screen.
    void openBelow(const QWidget& widget);

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
};

} // namespace ui

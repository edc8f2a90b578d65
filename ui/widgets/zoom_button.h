// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

namespace ui {

/// The status bar's zoom cell: a button with a menu, painted like the other cells.
class ZoomButton : public QToolButton {
    Q_OBJECT

public:
    explicit ZoomButton(QWidget* parent = nullptr);

    void setWidest(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace ui

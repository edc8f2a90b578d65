// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

#include <QWidget>

namespace ui {

constexpr int rulerWidth = 20;

/// Ticks in the drawing's unit along an edge of the canvas, with the clip window's span tinted and
/// a mark at the pointer. A drag from it makes a guide. 0 is the drawing's own origin, as in every
/// coordinate the editor shows.
class Ruler : public QWidget {
    Q_OBJECT

public:
    Ruler(Controller& controller, Qt::Orientation orientation, QWidget* parent);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    void paintTicks(QPainter& painter, double length);
    bool across() const { return orientation_ == Qt::Horizontal; }

    Controller& controller_;
    Qt::Orientation orientation_;
};

/// The corner where the rulers meet: shows the unit; a click opens the list of units.
class RulerCorner : public QWidget {
    Q_OBJECT

public:
    RulerCorner(const Controller& controller, QWidget* parent);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    const Controller& controller_;
};

} // namespace ui

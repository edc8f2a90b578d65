// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/paint.h"

#include <QWidget>

namespace ui {

/// Shows a cost map around the clip window, with a legend of its colours. The fixed end is dragged
/// with the pointer, or moved with the arrow keys, with Shift ten times as far.
class CostMapView : public QWidget {
    Q_OBJECT

public:
    explicit CostMapView(QWidget* parent = nullptr);

    /// `plan` is the requested map, `map` the best one computed for it so far; null: none yet.
    void show(const app::CostPlan& plan, const app::CostMap* map);
    /// How many cells, each a few pixels wide, fit.
    QSize cells(const app::CostPlan& plan) const;
    bool dragging() const { return dragging_; }
    /// The map's rectangle in the widget.
    QRectF place() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void fixedEndMoved(const app::Point& to);
    /// The pointer's position in the drawing; empty: it has left.
    void pointed(const std::optional<app::Point>& at);
    void dropped(); ///< a drag has ended
    void resized();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    app::CostMapLook look() const;
    QRectF room(double legend) const; ///< above a legend of this height
    void moveTo(const QPointF& pixel);

    app::CostPlan plan_;
    std::optional<app::CostMap> map_;
    bool dragging_ = false;
};

} // namespace ui

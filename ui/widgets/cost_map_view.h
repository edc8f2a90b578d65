// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/paint.h"

#include <QWidget>

namespace ui {

/// Shows a cost map around the clip window, and what its colours mean. The fixed end is dragged to
/// where the pointer is, or moved by the arrow keys, with Shift ten times as far.
class CostMapView : public QWidget {
    Q_OBJECT

public:
    explicit CostMapView(QWidget* parent = nullptr);

    /// What is asked for now, and the best map there is of it; null: none yet.
    void show(const app::CostPlan& plan, const app::CostMap* map);
    /// How many cells fit: each some pixels wide.
    QSize cells(const app::CostPlan& plan) const;
    bool dragging() const { return dragging_; }
    /// A map's place in the widget.
    QRectF place() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void fixedEndMoved(const app::Point& to);
    void pointed(const std::optional<app::Point>& at); ///< by the pointer; nothing: it left
    void dropped();                                    ///< a gesture is over
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
    QRectF room() const;
    void moveTo(const QPointF& pixel);

    app::CostPlan plan_;
    std::optional<app::CostMap> map_;
    bool dragging_ = false;
};

} // namespace ui

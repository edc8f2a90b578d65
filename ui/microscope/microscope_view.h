// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"
#include "app/teaching/microscope.h"
#include "ui/microscope/line_drag.h"

#include <QWidget>

namespace ui {

/// The microscope's current step, enlarged. The ends of the line are dragged, or selected with Tab
/// and moved with the arrow keys; the whole trace is updated. The visible part stays the same from
/// step to step. The wheel zooms, dragging beside the ends pans.
class MicroscopeView : public QWidget {
    Q_OBJECT

public:
    explicit MicroscopeView(app::Microscope& microscope, QWidget* parent = nullptr);

    const app::FigureFrame& frame() const { return frame_; }
    /// Reserves an area that labels avoid.
    void reserve(const QRectF& place);
    /// Keeps labels off the discs of answers.
    void leaveFree(std::vector<QRectF> discs);
    /// Whether labels name steps by their numbers: not where no steps are shown.
    void countSteps(bool counted);
    /// Fits window and line into the view.
    void fit();
    bool fitted() const { return fitted_; }
    void zoomBy(double factor);
    std::optional<LineEnd> chosenEnd() const { return chosen_; }
    bool drags() const { return drag_.has_value(); } ///< an end is dragged, or the view

    QSize sizeHint() const override { return {900, 520}; }
    QSize minimumSizeHint() const override { return {320, 180}; }

signals:
    /// In the drawing; empty: the pointer has left.
    void pointerMoved(std::optional<app::Point> point);
    void framed();                    ///< the visible part has changed
    void reframed();                  ///< the reserved area has changed, or the line
    void hinted(const QString& hint); ///< what the person can do here

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    struct Drag {
        std::optional<LineEnd> end; ///< empty: the drag pans
        clipping::Segment before;
        /// Offset from the pointer to the end; when panning, the last pointer position.
        QPointF handle;
    };

    void follow();
    void describe();
    void refit();
    void keepInSight();
    void moveEnd(LineEnd end, const app::Point& point);
    void choose(std::optional<LineEnd> end);
    void hover(const QPointF& place);
    void pan(const QPointF& by);
    void zoomAt(const QPointF& place, double factor);
    void cancelDrag();
    void paintRing(QPainter& painter, LineEnd end, double width) const;
    QString hint() const;

    app::Microscope& microscope_;
    app::FigureFrame frame_;
    QRectF reserved_;
    std::optional<LineEnd> chosen_, hovered_;
    std::optional<Drag> drag_;
    clipping::Segment line_{}; ///< as last seen
    bool movesEnd_ = false;    ///< this view is changing the line
    bool ring_ = false;        ///< the focus came by keyboard: paint the focus ring
    bool countsSteps_ = true;  ///< labels name steps by their numbers
    bool fitted_ = true;       ///< the person has neither zoomed nor panned
};

} // namespace ui

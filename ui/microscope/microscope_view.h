// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"
#include "app/teaching/microscope.h"
#include "ui/microscope/line_drag.h"

#include <QWidget>

namespace ui {

/// The step of the microscope, enlarged. The ends of the line are dragged, or chosen with Tab and
/// moved with the arrow keys: the whole trace follows. What is seen stays where it is from step to
/// step; the wheel zooms, dragging beside the ends moves it.
class MicroscopeView : public QWidget {
    Q_OBJECT

public:
    explicit MicroscopeView(app::Microscope& microscope, QWidget* parent = nullptr);

    const app::FigureFrame& frame() const { return frame_; }
    /// Labels keep clear of what lies there.
    void reserve(const QRectF& place);
    /// What the window is called: there may be none but the page.
    void setWindowIsPage(bool isPage);
    /// Window and line well in sight.
    void fit();
    bool fitted() const { return fitted_; }
    void zoomBy(double factor);
    std::optional<LineEnd> chosenEnd() const { return chosen_; }

    QSize sizeHint() const override { return {900, 520}; }
    QSize minimumSizeHint() const override { return {320, 180}; }

signals:
    void pointerMoved(std::optional<app::Point> point); ///< in the drawing; nothing: it has left
    void framed();                                      ///< what is seen has changed
    void hinted(const QString& hint);                   ///< what to do here

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
        std::optional<LineEnd> end; ///< nothing: what is seen is moved
        clipping::Segment before;
        QPointF grip; ///< from the pointer to the end; or where the pointer was
    };

    void follow();
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
    std::optional<LineEnd> chosen_, lit_;
    std::optional<Drag> drag_;
    bool windowIsPage_ = false;
    bool ring_ = false;  ///< the focus came by the keyboard: it is shown
    bool fitted_ = true; ///< the person has not zoomed or moved what is seen
};

} // namespace ui

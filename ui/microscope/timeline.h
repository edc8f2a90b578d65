// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/microscope.h"
#include "app/teaching/narration.h"

#include <QPainter>
#include <QWidget>

namespace ui {

/// The steps of a trace in a row, each with the mark of its kind. Click, drag, wheel and arrow keys
/// go to a step. All steps are always visible; if there are many, fewer have numbers.
class Timeline : public QWidget {
    Q_OBJECT

public:
    explicit Timeline(app::Microscope& microscope, QWidget* parent = nullptr);

    /// The position of a step's mark; used by tests and pictures.
    QPointF placeOf(std::size_t step) const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    void follow();
    double spacing() const;
    QRect answerCover() const;
    std::size_t stepAt(double x) const;
    std::size_t numberEvery() const;
    void paintRail(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void paintNumbers(QPainter& painter) const;
    void paintNow(QPainter& painter) const;

    app::Microscope& microscope_;
    int wheel_ = 0; ///< wheel rotation not used yet, in eighths of a degree
};

/// Paints a step's mark on the timeline or in its legend, centred on `middle` and at most 14 pixels
/// high: a dot, a vertical line, a divided circle, a diamond, or a circle with a tick, a cross or
/// an exclamation mark. `ground` is the background colour.
void paintMark(QPainter& painter, const QPointF& middle, app::Mark mark, const QColor& colour,
               const QColor& ground);
/// The word for a mark: "compare", "cut".
QString markWord(app::Mark mark);

} // namespace ui

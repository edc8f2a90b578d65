// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/microscope.h"

#include <QWidget>

namespace ui {

/// The steps of a trace in a row, each with the sign of what it does: click, drag, wheel and arrow
/// keys go to one. However many there are, all are in sight; then fewer have their numbers.
class Timeline : public QWidget {
    Q_OBJECT

public:
    explicit Timeline(app::Microscope& microscope, QWidget* parent = nullptr);

    /// Where the sign of a step is, for tests and pictures.
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
    double spacing() const;
    QRect veil() const;
    std::size_t stepAt(double x) const;
    std::size_t numberEvery() const;
    void paintRail(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void paintNumbers(QPainter& painter) const;
    void paintNow(QPainter& painter) const;

    app::Microscope& microscope_;
    int wheel_ = 0; ///< eighths of a degree not used yet
};

} // namespace ui

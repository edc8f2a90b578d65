// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exactness/magnifier_paint.h"

#include <QWidget>

namespace ui {

/// One end of a line, magnified down to single ulps. Wheel, + and −, Page Up and Page Down zoom,
/// dragging and the arrow keys move, Home restores the initial view.
class Magnifier : public QWidget {
    Q_OBJECT

public:
    explicit Magnifier(QWidget* parent = nullptr);

    /// Shows `seen` in the initial view; `name` is the algorithm's.
    void show(const app::Magnified& seen, const QString& name);
    void setLattice(app::Lattice lattice);
    const app::Magnified& seen() const { return seen_; }
    const app::MagnifierView& view() const { return view_; }

    QSize sizeHint() const override { return {520, 360}; }
    QSize minimumSizeHint() const override { return {200, 140}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void reset();
    void zoom(double factor, const QPointF& about);

    app::Magnified seen_{};
    app::MagnifierView view_;
    QString name_;
    QPointF last_;
    bool touched_ = false; ///< moved or zoomed by the person
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/handles.h"

#include <QWidget>

namespace ui {

/// Nine squares, one of which is chosen: the point of a box that X and Y mean, and that stays.
/// Click, or use the arrow keys.
class ReferencePoint : public QWidget {
    Q_OBJECT

public:
    explicit ReferencePoint(QWidget* parent = nullptr);

    app::Handle chosen() const { return chosen_; }
    void choose(app::Handle handle);
    QSize sizeHint() const override;

signals:
    void changed();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    QRectF squareOf(app::Handle handle) const;
    app::Handle handleAt(const QPointF& place) const;

    app::Handle chosen_{-1, -1};
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/page_steps.h"

#include <QWidget>

#include <optional>

namespace ui {

class Canvas;

/// Lies over the drawing while the sheet *Page* is open: the sizes of the page, and squares at its
/// edges that are dragged. Everything between them belongs to the canvas.
class PageFrame : public QWidget {
    Q_OBJECT

public:
    PageFrame(Canvas& canvas, app::Session& session, app::PageEditing& editing);

    bool isDragged() const { return dragged_.has_value(); }
    /// "297 mm on paper, 14.85 m drawn"; only the former at 1 : 1.
    QString sizeText(int axis) const;
    /// The middle of a square; -1, 0 or 1 across and down.
    QPointF square(int across, int down) const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Square {
        int across, down; ///< -1, 0 or 1
    };
    void follow();
    QRectF onScreen() const;
    QRectF labelPlace(int axis) const; ///< empty: there is no room
    std::optional<Square> squareAt(const QPointF& at) const;
    void drag(const QPointF& to);
    void paintSize(QPainter& painter, int axis) const;

    Canvas& canvas_;
    app::Session& session_;
    app::PageEditing& editing_;
    std::optional<Square> dragged_;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/page_steps.h"

#include <QWidget>

#include <optional>

namespace ui {

class Canvas;

/// Lies over the drawing while the sheet *Page* is open: the sizes of the page, and squares at its
/// edges and at those of its margins that are dragged. Dragged anywhere else on it, the page moves
/// below the drawing: the page stays where it is seen. Wheel and other buttons are the canvas's.
class PageFrame : public QWidget {
    Q_OBJECT

public:
    PageFrame(Canvas& canvas, app::Session& session, app::PageEditing& editing);

    bool isDragged() const { return dragged_.has_value(); }
    /// "297 mm on paper, 14.85 m drawn"; only the former at 1 : 1.
    QString sizeText(int axis) const;
    /// The edges that a square is at.
    enum class Edges : std::uint8_t { Page, Margins };
    /// The middle of a square; -1, 0 or 1 across and down.
    QPointF square(int across, int down, Edges of = Edges::Page) const;

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Square {
        int across, down; ///< -1, 0 or 1; both 0: the page itself
        Edges of = Edges::Page;
    };
    template <class Use>
    void forEachSquare(const Use& use) const;
    void follow();
    QRectF onScreen(Edges of = Edges::Page) const;
    QRectF labelPlace(int axis) const; ///< empty: there is no room
    std::optional<Square> squareAt(const QPointF& at) const;
    void drag(const QPointF& to, Qt::KeyboardModifiers keys);
    void dragEdge(const app::Point& to);
    void dragMargin(const app::Point& to, Qt::KeyboardModifiers keys);
    void dragPage(const QPointF& to);
    void paintSize(QPainter& painter, int axis) const;

    Canvas& canvas_;
    app::Session& session_;
    app::PageEditing& editing_;
    std::optional<Square> dragged_;
    QPointF last_; ///< where the pointer was
};

} // namespace ui

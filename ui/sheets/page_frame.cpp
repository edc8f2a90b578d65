// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/page_frame.h"

#include "app/base/numbers.h"
#include "app/document/paper.h"
#include "ui/canvas/canvas.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QMouseEvent>
#include <QPainter>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {
namespace {

constexpr double squareSize = 9, reach = 8, labelGap = 14, tick = 5; // pixels
constexpr int labelRoom = 6;

constexpr std::array<Qt::CursorShape, 9> cursorShapes{
    Qt::SizeFDiagCursor, Qt::SizeVerCursor, Qt::SizeBDiagCursor,
    Qt::SizeHorCursor,   Qt::ArrowCursor,   Qt::SizeHorCursor,
    Qt::SizeBDiagCursor, Qt::SizeVerCursor, Qt::SizeFDiagCursor};

QFont sizeFont(const QFont& font) { return captionFont(font); }

/// Calls `use` with the eight places around a rectangle.
template <class Use>
void forEachSquare(const Use& use)
{
    for (const int down : {-1, 0, 1})
        for (const int across : {-1, 0, 1})
            if (across != 0 || down != 0)
                use(across, down);
}

} // namespace

PageFrame::PageFrame(Canvas& canvas, app::Session& session, app::PageEditing& editing)
    : QWidget(canvas.paneSurface(0)), canvas_(canvas), session_(session), editing_(editing)
{
    setObjectName(QStringLiteral("page-frame"));
    setAccessibleName(Text::tr("Edges of the page"));
    setMouseTracking(true);
    connect(&canvas, &Canvas::viewChanged, this, &PageFrame::follow);
    connect(&session.document, &app::EditedDocument::changed, this, &PageFrame::follow);
    connect(&session, &app::Session::displayChanged, this, &PageFrame::follow);
    parentWidget()->installEventFilter(this);
    follow();
    show();
}

bool PageFrame::eventFilter(QObject*, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        follow();
    return false;
}

QRectF PageFrame::onScreen() const
{
    const app::View& view = canvas_.view();
    const clipping::Window page = session_.now().page().rectangle();
    const app::Point least(-1000), most = view.size + 1000.0; // painters fail far outside
    const app::Point min = glm::clamp(view.toScreen(page.min), least, most);
    const app::Point max = glm::clamp(view.toScreen(page.max), least, most);
    return {QPointF(min.x, min.y), QPointF(max.x, max.y)};
}

QPointF PageFrame::square(int across, int down) const
{
    const QRectF page = onScreen();
    return page.center() + QPointF(across * page.width() / 2, down * page.height() / 2);
}

QString PageFrame::sizeText(int axis) const
{
    const app::Page& page = session_.now().page();
    const app::Unit unit = session_.display().unit, onPaper = page.paperUnit(unit);
    const QString paper = app::withUnit(
        app::shortText(app::inUnit(app::millimetresOf(page)[axis], onPaper, 1), 5), onPaper);
    if (page.scale.ratio == 1)
        return paper;
    const double drawn = app::inUnit(page.size[axis], unit, page.realMillimetresPerUnit());
    return (axis == 0 ? Text::tr("%1 on paper, %2 drawn") : Text::tr("%1, %2"))
        .arg(paper, app::withUnit(app::shortText(drawn, 6), unit));
}

/// Turned to the left for the height.
QRectF PageFrame::labelPlace(int axis) const
{
    const QRectF page = onScreen();
    const QFontMetricsF metrics(sizeFont(font()));
    const QSizeF size(metrics.horizontalAdvance(sizeText(axis)) + 2 * labelRoom, metrics.height());
    QRectF place({}, axis == 0 ? size : size.transposed());
    place.moveCenter(axis == 0 ? QPointF(page.center().x(), page.top() - labelGap)
                               : QPointF(page.right() + labelGap, page.center().y()));
    const double room = axis == 0 ? page.width() : page.height();
    const bool fits = size.width() < room && QRectF(rect()).contains(place);
    return fits ? place : QRectF();
}

/// Only what is seen takes the pointer: the canvas has the rest.
void PageFrame::follow()
{
    setGeometry(parentWidget()->rect());
    QRegion seen;
    forEachSquare([&](int across, int down) {
        const double half = reach + 1;
        const QPointF at = square(across, down);
        seen += QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half).toAlignedRect();
    });
    const QRectF page = onScreen();
    if (!labelPlace(0).isEmpty())
        seen += QRectF(page.left() - 1, page.top() - labelGap - 10, page.width() + 2, 20)
                    .toAlignedRect();
    if (!labelPlace(1).isEmpty())
        seen += QRectF(page.right() + labelGap - 10, page.top() - 1, 20, page.height() + 2)
                    .toAlignedRect();
    setMask(seen);
    update();
}

void PageFrame::paintSize(QPainter& painter, int axis) const
{
    const QRectF label = labelPlace(axis), page = onScreen();
    if (label.isEmpty())
        return;
    const Look& look = lookOnPaper(session_.display().darkPaper);
    const QPointF away = axis == 0 ? QPointF(0, -labelGap) : QPointF(labelGap, 0);
    const QPointF from = (axis == 0 ? page.topLeft() : page.topRight()) + away;
    const QPointF to = (axis == 0 ? page.topRight() : page.bottomRight()) + away;
    const QPointF aside = axis == 0 ? QPointF(0, tick) : QPointF(tick, 0);
    painter.setPen(QPen(look.muted, 1));
    painter.drawLine(from, to);
    for (const QPointF& end : {from, to})
        painter.drawLine(end - aside, end + aside);
    painter.fillRect(label, look.canvas);
    painter.save();
    painter.translate(label.center());
    if (axis == 1)
        painter.rotate(-90);
    const QSizeF size = axis == 0 ? label.size() : label.size().transposed();
    painter.setPen(look.text);
    painter.drawText(QRectF(QPointF(-size.width() / 2, -size.height() / 2), size), Qt::AlignCenter,
                     sizeText(axis));
    painter.restore();
}

void PageFrame::paintEvent(QPaintEvent*)
{
    const Look& look = lookOnPaper(session_.display().darkPaper);
    QPainter painter(this);
    painter.setFont(sizeFont(font()));
    for (const int axis : {0, 1})
        paintSize(painter, axis);
    painter.setPen(QPen(look.selection, 1));
    painter.setBrush(look.paper);
    forEachSquare([&](int across, int down) {
        QRectF box(0, 0, squareSize, squareSize);
        box.moveCenter(square(across, down));
        painter.drawRect(box);
    });
}

std::optional<PageFrame::Square> PageFrame::squareAt(const QPointF& at) const
{
    std::optional<Square> found;
    forEachSquare([&](int across, int down) {
        const QPointF apart = square(across, down) - at;
        if (std::max(std::abs(apart.x()), std::abs(apart.y())) <= reach)
            found = Square{across, down};
    });
    return found;
}

void PageFrame::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        dragged_ = squareAt(event->position());
    event->setAccepted(dragged_.has_value()); // otherwise it is for the canvas
}

void PageFrame::mouseMoveEvent(QMouseEvent* event)
{
    if (dragged_)
        return drag(event->position());
    const auto over = squareAt(event->position());
    over ? setCursor(cursorShapes[std::size_t(4 + over->across + 3 * over->down)]) : unsetCursor();
}

void PageFrame::mouseReleaseEvent(QMouseEvent*) { dragged_.reset(); }

/// The size is a whole number of millimetres on paper; what is not dragged stays.
void PageFrame::drag(const QPointF& to)
{
    const app::Page& page = session_.now().page();
    clipping::Window edges = page.rectangle();
    const app::Point at = canvas_.view().toDrawing({to.x(), to.y()});
    const double unit = page.millimetresPerUnit();
    for (const int axis : {0, 1}) {
        const int side = axis == 0 ? dragged_->across : dragged_->down;
        if (side == 0)
            continue;
        const double fixed = (side < 0 ? edges.max : edges.min)[axis];
        const double millimetres =
            std::clamp(std::round(side * (at[axis] - fixed) * unit), 1.0, app::mostPaper);
        (side < 0 ? edges.min : edges.max)[axis] = fixed + side * millimetres / unit;
    }
    editing_.change(app::withEdges(page, edges));
}

} // namespace ui

#include "moc_page_frame.cpp"

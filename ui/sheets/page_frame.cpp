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
#include <utility>

namespace ui {
namespace {

constexpr double squareSize = 9, reach = 8, labelGap = 14, tick = 5; // pixels
constexpr int labelRoom = 6;

constexpr std::array<Qt::CursorShape, 9> cursorShapes{
    Qt::SizeFDiagCursor, Qt::SizeVerCursor, Qt::SizeBDiagCursor,
    Qt::SizeHorCursor,   Qt::SizeAllCursor, Qt::SizeHorCursor,
    Qt::SizeBDiagCursor, Qt::SizeVerCursor, Qt::SizeFDiagCursor};

QFont sizeFont(const QFont& font) { return captionFont(font); }

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

void PageFrame::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    canvas_.setHint(Text::tr("Drag an edge or a margin (Shift: all four). Drag inside: move the "
                             "drawing on the page. Esc: as it was."));
}

void PageFrame::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    canvas_.setHint({});
}

bool PageFrame::eventFilter(QObject*, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        follow();
    return false;
}

/// Calls `use` with the eight squares of the page, and those at the middle of its margins' edges.
template <class Use>
void PageFrame::forEachSquare(const Use& use) const
{
    for (const int down : {-1, 0, 1})
        for (const int across : {-1, 0, 1})
            if (across != 0 || down != 0)
                use(Square{across, down});
    if (session_.now().page().margins.shown)
        for (const auto& [across, down] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}})
            use(Square{across, down, Edges::Margins});
}

QRectF PageFrame::onScreen(Edges of) const
{
    const app::View& view = canvas_.view();
    const app::Page& whole = session_.now().page();
    const clipping::Window page = of == Edges::Page ? whole.rectangle() : app::insideOf(whole);
    const app::Point least(-1000), most = view.size + 1000.0; // painters fail far outside
    const app::Point min = glm::clamp(view.toScreen(page.min), least, most);
    const app::Point max = glm::clamp(view.toScreen(page.max), least, most);
    return {QPointF(min.x, min.y), QPointF(max.x, max.y)};
}

QPointF PageFrame::square(int across, int down, Edges of) const
{
    const QRectF page = onScreen(of);
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

/// Beside the page, only what is seen takes the pointer: the canvas has the rest.
void PageFrame::follow()
{
    setGeometry(parentWidget()->rect());
    const QRectF page = onScreen();
    const double half = reach + 1;
    QRegion taken(page.adjusted(-half, -half, half, half).toAlignedRect());
    if (!labelPlace(0).isEmpty())
        taken += QRectF(page.left() - 1, page.top() - labelGap - 10, page.width() + 2, 20)
                     .toAlignedRect();
    if (!labelPlace(1).isEmpty())
        taken += QRectF(page.right() + labelGap - 10, page.top() - 1, 20, page.height() + 2)
                     .toAlignedRect();
    setMask(taken);
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
    painter.setBrush(look.paper);
    forEachSquare([&](const Square& square) {
        QRectF box(0, 0, squareSize, squareSize);
        box.moveCenter(this->square(square.across, square.down, square.of));
        painter.setPen(QPen(square.of == Edges::Page ? look.selection : look.guide, 1));
        painter.drawRect(box);
    });
}

/// The page itself, where no square is.
std::optional<PageFrame::Square> PageFrame::squareAt(const QPointF& at) const
{
    std::optional<Square> found;
    if (onScreen().contains(at))
        found = Square{0, 0};
    forEachSquare([&](const Square& square) {
        const QPointF apart = this->square(square.across, square.down, square.of) - at;
        if (std::max(std::abs(apart.x()), std::abs(apart.y())) <= reach)
            found = square;
    });
    return found;
}

void PageFrame::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        dragged_ = squareAt(event->position());
    last_ = event->position();
    event->setAccepted(dragged_.has_value()); // otherwise it is for the canvas
}

void PageFrame::mouseMoveEvent(QMouseEvent* event)
{
    if (dragged_)
        return drag(event->position(), event->modifiers());
    const auto over = squareAt(event->position());
    over ? setCursor(cursorShapes[std::size_t(4 + over->across + 3 * over->down)]) : unsetCursor();
    event->setAccepted(over.has_value()); // nothing below it seems to be grasped
}

void PageFrame::mouseReleaseEvent(QMouseEvent* event)
{
    event->setAccepted(dragged_.has_value());
    dragged_.reset();
}

void PageFrame::drag(const QPointF& to, Qt::KeyboardModifiers keys)
{
    const app::Point at = canvas_.view().toDrawing({to.x(), to.y()});
    if (dragged_->of == Edges::Margins)
        dragMargin(at, keys);
    else if (dragged_->across == 0 && dragged_->down == 0)
        dragPage(to);
    else
        dragEdge(at);
}

/// The size is a whole number of millimetres on paper; what is not dragged stays.
void PageFrame::dragEdge(const app::Point& at)
{
    const app::Page& page = session_.now().page();
    clipping::Window edges = page.rectangle();
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

/// A whole number of millimetres; Shift: all four are alike.
void PageFrame::dragMargin(const app::Point& at, Qt::KeyboardModifiers keys)
{
    const app::Page& page = session_.now().page();
    const clipping::Window edges = page.rectangle();
    const int axis = dragged_->across != 0 ? 0 : 1, side = dragged_->across + dragged_->down;
    const double from = (side < 0 ? edges.min : edges.max)[axis];
    const double margin =
        std::max(0.0, std::round(side * (from - at[axis]) * page.millimetresPerUnit()));
    app::PaperMargins margins = page.margins;
    double* const sides[]{&margins.left, &margins.top, &margins.right, &margins.bottom};
    const std::size_t own = std::size_t(axis + (side < 0 ? 0 : 2));
    for (std::size_t i = 0; i < std::size(sides); ++i)
        if (i == own || keys.testFlag(Qt::ShiftModifier))
            *sides[i] = margin;
    editing_.change(app::withMargins(page, margins)); // margins that meet are refused
}

/// The drawing seems to move, because the view moves with the page.
void PageFrame::dragPage(const QPointF& to)
{
    app::Page page = session_.now().page();
    app::View view = canvas_.view();
    const QPointF by = std::exchange(last_, to) - to;
    const app::Point step = app::Point(by.x(), by.y()) / view.zoom;
    page.min += step;
    view.centre += step;
    canvas_.go(view);
    editing_.change(app::Result<app::Page>::of(std::move(page)));
}

} // namespace ui

#include "moc_page_frame.cpp"

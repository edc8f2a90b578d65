// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tiles/tiles_view.h"

#include "app/tiles/left_out.h"
#include "ui/look/text.h"
#include "ui/tiles/sheet_painter.h"
#include "ui/widgets/spoken_role.h"

#include <QApplication>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPainter>

#include <glm/common.hpp>

#include <algorithm>

namespace ui {
namespace {

constexpr double reach = 5;        // pixels from an edge that is dragged
constexpr int roomForTags = 26;    // pixels above the sheets
constexpr double slightZoom = 1.2; // by a key

clipping::Window common(const clipping::Window& a, const clipping::Window& b)
{
    return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
            {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

bool isEmpty(const clipping::Window& window)
{
    return !(window.min.x < window.max.x && window.min.y < window.max.y);
}

} // namespace

TilesView::TilesView(app::Session& session, app::LiveSheets& sheets,
                     app::SheetArrangement arrangement, Use use, QWidget* parent)
    : QWidget(parent), session_(session), sheets_(sheets), arrangement_(arrangement), use_(use),
      art_(session, sheets)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    if (use == Use::Full) {
        setSpokenRole(*this, QAccessible::Canvas);
        setFocusPolicy(Qt::StrongFocus);
        setMouseTracking(true);
        setAccessibleName(Text::tr("Sheets"));
        setObjectName(QStringLiteral("sheets-view"));
    } else {
        setAccessibleName(Text::tr("Overview of the sheets"));
    }
    connect(&navigation_, &Navigation::moved, this, qOverload<>(&QWidget::update));
    connect(&art_, &SheetArt::painted, this, qOverload<>(&QWidget::update));
    connect(&art_, &SheetArt::frameShown, this, &TilesView::frameShown);
    connect(&sheets, &app::LiveSheets::changed, this, &TilesView::follow);
    connect(&sheets, &app::LiveSheets::openChanged, this, [this] {
        art_.forget(); // the scene of a closed drawing is gone
        layout_.reset();
        follow();
    });
    connect(&session.scene, &app::Scene::outdated, this, &TilesView::outdate);
    connect(&session, &app::Session::displayChanged, this, &TilesView::outdate);
    follow();
}

void TilesView::outdate()
{
    ++revision_;
    update();
}

/// Fits the sheets into the view again if they are others; the view stays while only cuts move.
void TilesView::follow()
{
    if (!sheets_.isOpen())
        return;
    const auto before = std::exchange(layout_, std::nullopt);
    if (const auto& tiling = sheets_.tiling())
        layout_ = app::layoutOf(*tiling.value, sheets_.settings().plan.margin, arrangement_);
    const auto sizeOf = [](const app::SheetLayout& layout) {
        return layout.bounds.max - layout.bounds.min;
    };
    if (layout_ && !drag_ && (!before || sizeOf(*before) != sizeOf(*layout_)))
        fit();
    outdate();
}

void TilesView::arrange(app::SheetArrangement arrangement)
{
    if (arrangement == arrangement_)
        return;
    arrangement_ = arrangement;
    art_.forget();
    layout_.reset();
    follow();
}

void TilesView::tintOverlaps(bool tinted)
{
    tinted_ = tinted;
    update();
}

void TilesView::fit()
{
    if (!layout_)
        return;
    clipping::Window all = layout_->bounds;
    if (use_ == Use::Full && arrangement_ == app::SheetArrangement::Apart && height() > roomForTags)
        all.min.y -= (all.max.y - all.min.y) * roomForTags / height();
    navigation_.show(all);
}

void TilesView::zoomBy(double factor)
{
    navigation_.zoomAt(QPointF(width(), height()) / 2, factor);
}

QPointF TilesView::middleOf(std::size_t sheet) const
{
    const clipping::Window& part = layout_.value().places.at(sheet).part;
    const app::Point middle = navigation_.view().toScreen((part.min + part.max) * 0.5);
    return {middle.x, middle.y};
}

/// Of whole pixels, so that it need not be scaled when it is painted.
SheetWish TilesView::wishFor(std::size_t sheet, const clipping::Window& shown) const
{
    const app::View& view = navigation_.view();
    const double ratio = devicePixelRatioF();
    const app::Point from = glm::floor(view.toScreen(shown.min) * ratio) / ratio;
    const app::Point to = glm::ceil(view.toScreen(shown.max) * ratio) / ratio;
    SheetWish wish;
    wish.sheet = sheet;
    wish.view.zoom = view.zoom * layout_->millimetresPerUnit;
    wish.view.size = to - from;
    wish.view.centre = layout_->toDrawing(sheet, view.toDrawing((from + to) * 0.5));
    return wish;
}

/// In place one picture of the whole drawing, with the rest of it ghosted; apart one for each sheet
/// in view.
std::vector<SheetWish> TilesView::wishes() const
{
    std::vector<SheetWish> all;
    const app::Tiling& tiling = *sheets_.tiling().value;
    const clipping::Window seen = navigation_.view().visible();
    if (arrangement_ == app::SheetArrangement::InPlace) {
        SheetWish wish = wishFor(0, seen);
        wish.removed = app::RemovedPart::Ghosted;
        if (tiling.written() == int(tiling.tiles.size()))
            wish.region.steps.push_back({tiling.whole(), app::WindowOperation::Add});
        else
            for (const app::Tile& tile : tiling.tiles)
                if (!tile.leftOut)
                    wish.region.steps.push_back({tile.window, app::WindowOperation::Add});
        all.push_back(std::move(wish));
        return all;
    }
    for (std::size_t i = 0; i < layout_->places.size(); ++i) {
        const clipping::Window shown = common(layout_->places[i].paper, seen);
        if (isEmpty(shown))
            continue;
        all.push_back(wishFor(i, shown));
        all.back().region.steps.push_back({tiling.tiles[i].window, app::WindowOperation::Add});
    }
    return all;
}

void TilesView::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    const Look& onPaper = lookOnPaper(session_.display().darkPaper);
    QPainter painter(this);
    painter.fillRect(rect(), use_ == Use::Full ? onPaper.canvas : look.panel);
    if (!sheets_.isOpen())
        return;
    if (!layout_) {
        painter.setPen(use_ == Use::Full ? onPaper.muted : look.muted);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         sheets_.tiling().error);
        return;
    }
    want();
    SheetPainter sheets(painter, sheets_, *layout_, navigation_.view(), onPaper);
    sheets.paintPapers(tinted_);
    sheets.paintPictures(art_.pictures());
    sheets.paintEdges();
    sheets.paintMarks();
    sheets.paintTags(captionFont(font()), use_ == Use::Full);
}

void TilesView::want()
{
    if (sheets_.isOpen() && layout_)
        art_.want(wishes(), revision_, lookOnPaper(session_.display().darkPaper),
                  devicePixelRatioF());
}

// Not by repaint(), which paints later if this window was composed less than a frame ago.
void TilesView::settle()
{
    want();
    art_.settle();
    repaint();
}

/// The room for the tags is a part of the height.
void TilesView::resizeEvent(QResizeEvent*)
{
    const bool fitted = navigation_.isFitted();
    navigation_.resize({width(), height()});
    if (fitted)
        fit();
}

void TilesView::wheelEvent(QWheelEvent* event)
{
    if (use_ == Use::Overview)
        return event->ignore();
    navigation_.wheel(*event);
    event->accept();
}

bool TilesView::event(QEvent* event)
{
    if (event->type() == QEvent::NativeGesture && use_ == Use::Full
        && navigation_.gesture(*static_cast<QNativeGestureEvent*>(event)))
        return true;
    if (event->type() == QEvent::PaletteChange)
        outdate();
    return QWidget::event(event);
}

app::Point TilesView::layoutAt(const QPointF& screen) const
{
    return navigation_.view().toDrawing({screen.x(), screen.y()});
}

/// Sheets of a given number are just as large as the drawing needs: their cuts cannot move.
std::optional<int> TilesView::edgeAt(const QPointF& screen) const
{
    if (!layout_ || sheets_.settings().byNumber)
        return std::nullopt;
    return layout_->edgeAt(layoutAt(screen), reach / navigation_.view().zoom);
}

void TilesView::showCursor(const QPointF& at)
{
    const auto edge = edgeAt(at);
    if (edge)
        setCursor(*edge == 0 ? Qt::SplitHCursor : Qt::SplitVCursor);
    else if (layout_ && layout_->sheetAt(layoutAt(at)))
        setCursor(Qt::PointingHandCursor);
    else
        setCursor(Qt::OpenHandCursor);
}

void TilesView::mousePressEvent(QMouseEvent* event)
{
    const bool left = event->button() == Qt::LeftButton;
    if (use_ == Use::Overview || (!left && event->button() != Qt::MiddleButton))
        return event->ignore();
    const QPointF at = event->position();
    drag_ = Drag{at, at, left ? edgeAt(at) : std::nullopt, sheets_.settings().plan.shift, !left};
}

void TilesView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF at = event->position();
    if (use_ == Use::Overview)
        return event->ignore();
    if (!drag_)
        return showCursor(at);
    drag_->moved =
        drag_->moved || (at - drag_->from).manhattanLength() >= QApplication::startDragDistance();
    if (!drag_->moved)
        return;
    if (drag_->edge)
        return shift(at);
    setCursor(Qt::ClosedHandCursor);
    navigation_.pan(at - drag_->last);
    drag_->last = at;
}

void TilesView::mouseReleaseEvent(QMouseEvent* event)
{
    const auto drag = std::exchange(drag_, std::nullopt);
    if (!drag)
        return event->ignore();
    if (!drag->moved && layout_)
        if (const auto sheet = layout_->sheetAt(layoutAt(event->position())))
            toggle(*sheet);
    showCursor(event->position());
}

/// Its two clicks leave the sheet as it was.
void TilesView::mouseDoubleClickEvent(QMouseEvent* event)
{
    mousePressEvent(event);
    if (use_ == Use::Full)
        fit();
}

void TilesView::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal)
        zoomBy(slightZoom);
    else if (event->key() == Qt::Key_Minus)
        zoomBy(1 / slightZoom);
    else if (event->key() == Qt::Key_Home)
        fit();
    else
        QWidget::keyPressEvent(event);
}

void TilesView::toggle(std::size_t sheet)
{
    const app::Tiling& tiling = *sheets_.tiling().value;
    const app::Tile& tile = tiling.tiles[sheet];
    app::SheetSettings next = sheets_.settings();
    if (tile.empty && !isLeftOut(next.plan, tiling, tile))
        return emit hinted(
            Text::tr("Sheet %1-%2 is empty. Clear “Leave out empty sheets” to export it.")
                .arg(tile.row)
                .arg(tile.column));
    next.plan = toggled(next.plan, tiling, tile);
    sheets_.change(std::move(next));
}

/// The edge stays under the pointer.
void TilesView::shift(const QPointF& to)
{
    const int axis = *drag_->edge;
    const QPointF way = (to - drag_->from) / navigation_.view().zoom;
    app::SheetSettings next = sheets_.settings();
    next.plan.shift[axis] = drag_->shift[axis] - (axis == 0 ? way.x() : way.y());
    sheets_.change(std::move(next));
}

} // namespace ui

#include "moc_tiles_view.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/commands/move_objects.h"
#include "app/commands/remove_objects.h"
#include "app/commands/resize_objects.h"
#include "app/session/first_traced_line.h"
#include "ui/tools/shape_drawing.h"
#include "ui/tools/window_gesture.h"

#include <QCoreApplication>

#include <glm/common.hpp>

#include <cmath>

namespace ui {
namespace {

constexpr double boxReach = 8; // pixels
// Limit of previewed segments while a selection is dragged.
constexpr std::size_t mostPreviewed = 4000;

/// Selects objects by clicks and boxes, and drags them; also drags the clip window by its handles
/// and outline.
class SelectTool final : public Tool {
public:
    void press(const Pointer& pointer, Workbench& bench) override;
    void move(const Pointer& pointer, Workbench& bench) override;
    void release(const Pointer& pointer, Workbench& bench) override;
    void doubleClick(const Pointer& pointer, Workbench& bench) override;
    void leave(Workbench&) override
    {
        if (!busy())
            forgetHovered();
    }
    bool key(QKeyEvent& event, Workbench& bench) override;
    void cancel(Workbench& bench) override
    {
        gesture_.cancel(bench);
        drag_ = Drag::None;
    }
    bool busy() const override { return gesture_.going() || drag_ != Drag::None; }

    QCursor cursor(const Workbench& bench) const override;
    app::SnapTo snapsTo() const override { return app::SnapTo::Nothing; }
    bool showsHandles() const override { return true; }
    std::optional<app::Handle> hoveredHandle() const override { return hoveredHandle_; }
    std::optional<std::size_t> hoveredSegment() const override { return hoveredSegment_; }
    QString hint(const Workbench& bench) const override;
    void paint(QPainter& painter, const Workbench& bench) const override;

private:
    enum class Drag : std::uint8_t { None, Press, Box, Selection };

    void forgetHovered()
    {
        hoveredHandle_.reset();
        boxHandle_.reset();
        hoveredSegment_.reset();
    }
    void light(const Pointer& pointer, Workbench& bench);
    void click(const Pointer& pointer, Workbench& bench);
    void selectBox(const Pointer& pointer, Workbench& bench);
    void startDrag(Workbench& bench);
    void finishDrag(Workbench& bench);
    app::Point offset() const { return to_.raw - from_.raw; }
    clipping::Window target() const; ///< the selection's bounds after the drag
    void paintBox(QPainter& painter, const Workbench& bench) const;
    void paintBounds(QPainter& painter, const Workbench& bench,
                     const clipping::Window& bounds) const;
    void paintMoved(QPainter& painter, const Workbench& bench) const;

    WindowGesture gesture_;
    std::optional<app::Handle> hoveredHandle_;
    /// Dragged or hovered handle of the selection's bounding box.
    std::optional<app::Handle> boxHandle_;
    std::optional<std::size_t> hoveredSegment_; ///< hovered segment of the scene
    clipping::Window bounds_{};                 ///< the selection's bounds when the drag began
    Drag drag_ = Drag::None;
    Pointer from_{}, to_{};
};

// A single line has no bounding box; it shows its ends instead.
std::optional<clipping::Window> boxAround(const app::Session& session)
{
    const bool single = session.selection().size() == 1 && session.inspected();
    return single ? std::nullopt : session.selectionBounds();
}

void SelectTool::light(const Pointer& pointer, Workbench& bench)
{
    const auto window = bench.session.clipWindow();
    hoveredHandle_ = window ? app::handleAt(pointer.screen, *window, bench.view) : std::nullopt;
    const auto box = hoveredHandle_ ? std::nullopt : boxAround(bench.session);
    boxHandle_ = box ? app::handleAt(pointer.screen, *box, bench.view, boxReach) : std::nullopt;
    hoveredSegment_ = hoveredHandle_ || boxHandle_
                          ? std::nullopt
                          : bench.picking.nearest(pointer.raw, bench.inDrawing(reach));
}

void SelectTool::press(const Pointer& pointer, Workbench& bench)
{
    light(pointer, bench);
    if (hoveredHandle_) {
        gesture_.start(*hoveredHandle_, pointer, bench.session.window());
        return;
    }
    from_ = to_ = pointer;
    drag_ = Drag::Press;
}

void SelectTool::move(const Pointer& pointer, Workbench& bench)
{
    if (gesture_.going()) {
        gesture_.proceed(pointer, bench);
        return;
    }
    if (drag_ == Drag::None) {
        light(pointer, bench);
        return;
    }
    to_ = pointer;
    if (drag_ == Drag::Press && dragged(from_.screen, pointer))
        startDrag(bench);
}

// In the area of an unselected object the drag draws a selection box; otherwise a background could
// not be dragged across.
void SelectTool::startDrag(Workbench& bench)
{
    const app::Session& session = bench.session;
    const auto area = bench.picking.areaAt(from_.raw);
    const bool inSelection = area && session.selection().contains(*area);
    drag_ = hoveredSegment_ || boxHandle_ || inSelection ? Drag::Selection : Drag::Box;
    if (hoveredSegment_
        && !session.selection().contains(session.scene.lines().objectOf(*hoveredSegment_)))
        click(from_, bench);
    bounds_ = session.selectionBounds().value_or(clipping::Window{});
}

clipping::Window SelectTool::target() const
{
    const auto proportion =
        to_.modifiers & Qt::ShiftModifier ? app::Proportion::Kept : app::Proportion::Free;
    return app::dragged(bounds_, boxHandle_.value_or(app::Handle{}), offset(), proportion,
                        anchorOf(to_.modifiers));
}

// Keeps the inspected line if the drag has only changed its coordinates.
void SelectTool::finishDrag(Workbench& bench)
{
    app::Session& session = bench.session;
    const auto inspected = session.inspected();
    const std::size_t lines = session.scene.lines().size();
    if (boxHandle_.value_or(app::Handle{}) == app::Handle{})
        session.history.push(new app::MoveObjects(session.document, session.selection(), offset()));
    else
        session.history.push(
            new app::ResizeObjects(session.document, session.selection(), bounds_, target()));
    // Otherwise a curve has been divided into other lines.
    if (session.scene.lines().size() == lines)
        session.inspect(inspected);
}

void SelectTool::release(const Pointer& pointer, Workbench& bench)
{
    if (gesture_.going()) {
        gesture_.finish(pointer, bench);
        return;
    }
    to_ = pointer;
    const Drag drag = std::exchange(drag_, Drag::None);
    if (drag == Drag::Press)
        click(from_, bench);
    else if (drag == Drag::Box)
        selectBox(pointer, bench);
    else if (drag == Drag::Selection)
        finishDrag(bench);
    hoveredSegment_.reset();
}

/// Opens the line in the microscope.
void SelectTool::doubleClick(const Pointer& pointer, Workbench& bench)
{
    const auto segment = bench.picking.nearest(pointer.raw, bench.inDrawing(reach));
    if (!segment)
        return press(pointer, bench);
    bench.session.inspect(segment);
    bench.session.microscope.open(app::tracedLineOf(bench.session, *segment));
}

void SelectTool::click(const Pointer& pointer, Workbench& bench)
{
    app::Session& session = bench.session;
    const auto segment = bench.picking.nearest(pointer.raw, bench.inDrawing(reach));
    const auto shape = segment ? std::optional(session.scene.lines().objectOf(*segment))
                               : bench.picking.areaAt(pointer.raw);
    const bool adds = pointer.modifiers & Qt::ShiftModifier;
    auto selection = adds ? session.selection() : app::ObjectRanges{};
    bool chosen = segment.has_value();
    if (shape && !selection.insert(*shape)) {
        selection.erase(*shape);
        chosen = false;
    }
    session.select(std::move(selection));
    session.inspect(chosen ? segment : std::nullopt);
}

// Dragged from left to right the box selects what it contains, from right to left what it touches.
void SelectTool::selectBox(const Pointer& pointer, Workbench& bench)
{
    const auto how = pointer.screen.x >= from_.screen.x ? app::Picking::Box::Contains
                                                        : app::Picking::Box::Touches;
    auto found = bench.picking.objectsIn(app::between(from_.raw, pointer.raw), how);
    if (pointer.modifiers & Qt::ShiftModifier)
        found = united(found, bench.session.selection());
    bench.session.select(std::move(found));
    bench.session.inspect(std::nullopt);
}

bool SelectTool::key(QKeyEvent& event, Workbench& bench)
{
    app::Session& session = bench.session;
    if ((event.key() != Qt::Key_Delete && event.key() != Qt::Key_Backspace)
        || session.selection().empty() || busy())
        return false;
    session.history.push(new app::RemoveObjects(session.document, session.selection()));
    hoveredSegment_.reset();
    return true;
}

// A hint about the hovered object, else about the selection.
QString SelectTool::hint(const Workbench& bench) const
{
    const app::Session& session = bench.session;
    if (hoveredSegment_ && *hoveredSegment_ < session.scene.lines().size() && drag_ == Drag::None) {
        const app::Containers& containers = session.now().containers();
        const auto layer = containers.layerOf(session.scene.lines().objectOf(*hoveredSegment_));
        return QCoreApplication::translate(
                   "Tools",
                   "Line %1 in %2. Click selects it, Shift+click adds it, dragging moves it.")
            .arg(app::countText(*hoveredSegment_ + 1), containers[layer].name);
    }
    if (!session.selection().empty())
        return QCoreApplication::translate(
                   "Tools", "%1 selected. Dragging or the arrow keys move, Delete removes.")
            .arg(app::countText(session.selection().size()));
    if (const auto line = session.inspected())
        return QCoreApplication::translate(
                   "Tools", "The Line panel shows line %1. Click a line to select it.")
            .arg(app::countText(*line + 1));
    return {};
}

QCursor SelectTool::cursor(const Workbench&) const
{
    if (hoveredHandle_ || gesture_.going())
        return cursorOf(hoveredHandle_.value_or(app::Handle{}));
    if (boxHandle_)
        return cursorOf(*boxHandle_);
    return drag_ == Drag::Selection ? Qt::SizeAllCursor : Qt::ArrowCursor;
}

void SelectTool::paint(QPainter& painter, const Workbench& bench) const
{
    if (drag_ == Drag::Box)
        paintBox(painter, bench);
    if (drag_ == Drag::Selection)
        paintMoved(painter, bench);
    if (const auto bounds = boxAround(bench.session))
        paintBounds(painter, bench, drag_ == Drag::Selection ? target() : *bounds);
}

void SelectTool::paintBox(QPainter& painter, const Workbench& bench) const
{
    const bool touches = to_.screen.x < from_.screen.x;
    QColor tint = bench.look.selection;
    tint.setAlphaF(0.08F);
    painter.setBrush(tint);
    painter.setPen(QPen(bench.look.selection, 1, touches ? Qt::DashLine : Qt::SolidLine));
    painter.drawRect(QRectF(bench.onScreen(from_.raw), bench.onScreen(to_.raw)).normalized());
}

// Paints the selection's bounding box with round handles at its corners and sides.
void SelectTool::paintBounds(QPainter& painter, const Workbench& bench,
                             const clipping::Window& box) const
{
    painter.setPen(QPen(bench.look.selection, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(bench.onScreen(box.min), bench.onScreen(box.max)));
    painter.setPen(QPen(bench.look.selection, 1.5));
    painter.setBrush(bench.look.paper);
    for (const app::PlacedHandle& placed : app::placedHandles(box, bench.view))
        painter.drawEllipse(QPointF(placed.screen.x, placed.screen.y), 4, 4);
}

void SelectTool::paintMoved(QPainter& painter, const Workbench& bench) const
{
    const app::SceneLines& all = bench.session.scene.lines();
    const app::Placement where = app::fitting(bounds_, target());
    const auto at = [&](const app::Point& p) { return bench.onScreen(where(p)); };
    std::vector<QLineF> lines;
    for (const std::size_t shape : bench.session.selection()) {
        if (lines.size() >= mostPreviewed)
            break;
        const auto end = all.firstLineOf(shape + 1);
        for (auto i = all.firstLineOf(shape); i < end && lines.size() < mostPreviewed; ++i)
            lines.emplace_back(at(all[i].a), at(all[i].b));
    }
    painter.setPen(QPen(bench.look.selection, 1.5));
    painter.drawLines(lines.data(), int(lines.size()));
}

} // namespace

std::unique_ptr<Tool> makeSelectTool() { return std::make_unique<SelectTool>(); }

} // namespace ui

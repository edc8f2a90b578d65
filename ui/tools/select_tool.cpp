// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/commands/add_and_remove.h"
#include "app/session/inspection.h"
#include "app/session/window_words.h"
#include "ui/look/text.h"
#include "ui/tools/box_resize.h"
#include "ui/tools/end_drag.h"
#include "ui/tools/group_choice.h"
#include "ui/tools/guide_drag.h"
#include "ui/tools/picking_marks.h"
#include "ui/tools/pivot_marks.h"
#include "ui/tools/selection_marks.h"
#include "ui/tools/shape_drawing.h"
#include "ui/tools/transform_gesture.h"
#include "ui/tools/window_gesture.h"

#include <glm/geometric.hpp>

namespace ui {
namespace {

constexpr double boxReach = 8; // pixels

/// %1 is the name of the clip window.
QString handleHint(app::Handle handle)
{
    if (handle == app::Handle{})
        return Text::tr("Drag: move the clip window %1. Right click: its menu.");
    if (handle == app::rotationHandle)
        return Text::tr("Drag: rotate the clip window %1. Right click: its menu.");
    return Text::tr("Drag: resize the clip window %1. Right click: its menu.");
}

/// Selects objects by clicks and boxes, and drags them; also drags the clip window by its handles
/// and outline.
class SelectTool final : public Tool,
                         public TakesKeys,
                         public TypesNumbers,
                         public Snaps,
                         public Hovers,
                         public Transforms {
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
    bool wants(const QKeyEvent& event, const Workbench& bench) const override
    {
        return transform_.wants(event) || (deletes(event) && choosesGuide(bench));
    }
    void cancel(Workbench& bench) override
    {
        gesture_.cancel(bench);
        end_.cancel(bench);
        guide_.cancel();
        transform_.cancel(bench);
        resize_.cancel(bench);
        drag_ = Drag::None;
    }
    bool busy() const override
    {
        return gesture_.going() || end_.going() || guide_.going() || transform_.going()
               || resize_.going() || drag_ != Drag::None;
    }
    void transform(const app::Transformation& kind, const Pointer& pointer,
                   Workbench& bench) override;
    std::optional<app::Gauge> gauge(const Workbench& bench) const override;
    void accept(const app::GestureEnd& end, Workbench& bench) override;
    void reopen(Workbench& bench) override // only one of them has made the last step
    {
        end_.reopen(bench);
        resize_.reopen(bench);
        transform_.reopen(bench);
    }
    bool corrects() const override
    {
        return end_.corrects() || resize_.corrects() || transform_.corrects();
    }

    QCursor cursor(const Workbench& bench) const override;
    void limit(app::SnapQuery& query) const override
    {
        if (!gesture_.going() && !end_.going() && !guide_.going() && drag_ != Drag::Pivot)
            query.to = app::SnapTo::Nothing;
        if (const auto object = end_.object())
            query.without = {*object};
        query.withoutWindow = gesture_.number();
    }
    const app::MovedSnap* snapped() const override
    {
        return transform_.going() ? transform_.snapped()
               : resize_.going()  ? resize_.snapped()
                                  : gesture_.snapped();
    }
    std::optional<app::Handle> hoveredHandle() const override { return hoveredHandle_; }
    std::optional<std::size_t> hoveredSegment() const override { return hoveredSegment_; }
    QString hint(const Workbench& bench) const override;
    void paint(QPainter& painter, const Workbench& bench) const override;

private:
    enum class Drag : std::uint8_t { None, Press, Box, Resize, Transform, Pivot };
    using Mark = PivotMarks::Mark;

    static bool deletes(const QKeyEvent& event)
    {
        return event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace;
    }
    /// Whether numbers and Delete are for a guide.
    bool choosesGuide(const Workbench& bench) const
    {
        return guide_.going() || (!busy() && GuideDrag::chosen(bench));
    }
    /// The next action begins: numbers no longer change the last step.
    void forgetSteps(Workbench& bench)
    {
        end_.end(bench);
        resize_.end(bench);
        transform_.end(bench);
    }
    void forgetHovered()
    {
        hoveredHandle_.reset();
        hoveredEnd_.reset();
        hoveredGuide_.reset();
        boxHandle_.reset();
        hoveredSegment_.reset();
        mark_ = Mark::None;
        near_ = false;
    }
    void lookUnder(const Pointer& pointer, Workbench& bench);
    void lookNear(const Pointer& pointer, const Workbench& bench);
    void click(const Pointer& pointer, Workbench& bench);
    app::Picking::Box how(const Pointer& pointer) const;
    void selectBox(const Pointer& pointer, Workbench& bench);
    void startDrag(Workbench& bench);
    void start(const app::Transformation& kind, const app::Point& pointer, Workbench& bench);

    WindowGesture gesture_;
    TransformGesture transform_;
    BoxResize resize_;
    EndDrag end_;
    GuideDrag guide_;
    std::optional<EndDrag::End> hoveredEnd_;
    std::optional<app::Handle> hoveredHandle_;
    std::optional<std::size_t> hoveredGuide_;
    /// Dragged or hovered handle of the selection's bounding box.
    std::optional<app::Handle> boxHandle_;
    std::optional<std::size_t> hoveredSegment_; ///< hovered segment of the scene
    Mark mark_ = Mark::None;                    ///< hovered
    bool near_ = false;                         ///< the pointer is near the selection
    Drag drag_ = Drag::None;
    Pointer from_{}, to_{};
};

// A single line has no bounding box; it shows its ends instead.
std::optional<clipping::Window> boxAround(const app::Session& session)
{
    return lineWithHandles(session) ? std::nullopt : session.selectionBounds();
}

void SelectTool::lookUnder(const Pointer& pointer, Workbench& bench)
{
    hoveredHandle_ = windowHandleAt(pointer.screen, bench);
    hoveredEnd_ = hoveredHandle_ ? std::nullopt : EndDrag::endAt(pointer.screen, bench);
    const auto box = hoveredHandle_ ? std::nullopt : boxAround(bench.session);
    mark_ = hoveredHandle_ || hoveredEnd_ ? Mark::None : PivotMarks::at(pointer.screen, bench);
    boxHandle_ = box && mark_ == Mark::None ? app::handleAt(
                     pointer.screen, SelectionMarks::boxAround(*box, bench), bench.view, boxReach)
                                            : std::nullopt;
    lookNear(pointer, bench);
    hoveredSegment_ = hoveredHandle_ || boxHandle_ || mark_ != Mark::None
                          ? std::nullopt
                          : bench.picking.nearest(pointer.raw, bench.inDrawing(reach));
    const bool other = hoveredHandle_ || hoveredEnd_ || boxHandle_ || hoveredSegment_;
    hoveredGuide_ =
        other || mark_ != Mark::None ? std::nullopt : GuideDrag::guideAt(pointer.screen, bench);
}

void SelectTool::lookNear(const Pointer& pointer, const Workbench& bench)
{
    const auto& bounds = bench.session.selectionBounds();
    near_ = bounds && SelectionMarks::isNear(pointer.screen, *bounds, bench);
}

void SelectTool::press(const Pointer& pointer, Workbench& bench)
{
    if (transform_.going() && !transform_.corrects()) {
        transform_.proceed(pointer, bench);
        return transform_.finish(bench);
    }
    forgetSteps(bench);
    bench.session.guide.reset();
    lookUnder(pointer, bench);
    if (hoveredHandle_) {
        gesture_.start(*hoveredHandle_, pointer, bench);
        return;
    }
    if (hoveredGuide_)
        return guide_.start(*hoveredGuide_, bench);
    if (hoveredEnd_)
        return end_.start(*hoveredEnd_, pointer, bench);
    from_ = to_ = pointer;
    drag_ = Drag::Press;
}

void SelectTool::move(const Pointer& pointer, Workbench& bench)
{
    to_ = pointer;
    if (gesture_.going())
        gesture_.proceed(pointer, bench);
    else if (end_.going())
        end_.proceed(pointer, bench);
    else if (guide_.going())
        guide_.proceed(pointer);
    else if (resize_.going())
        resize_.proceed(pointer, bench);
    else if (transform_.going())
        transform_.proceed(pointer, bench);
    else if (drag_ == Drag::Pivot)
        bench.session.pivot.put(pointer.position);
    else if (drag_ == Drag::None)
        lookUnder(pointer, bench);
    else if (drag_ == Drag::Press && dragged(from_.screen, pointer))
        startDrag(bench);
}

// In the area of an unselected object the drag draws a selection box; otherwise a background could
// not be dragged across.
void SelectTool::startDrag(Workbench& bench)
{
    const app::Session& session = bench.session;
    if (mark_ == Mark::Rotation)
        return start(*app::findTransformation("rotate"), from_.raw, bench);
    if (mark_ == Mark::Pivot) {
        drag_ = Drag::Pivot;
        return;
    }
    if (boxHandle_.value_or(app::Handle{}) != app::Handle{}) {
        drag_ = Drag::Resize;
        return resize_.start(*boxHandle_, *boxAround(session), from_, bench);
    }
    const auto area = bench.picking.areaAt(from_.raw);
    const bool inSelection = area && session.selection().contains(*area);
    if (!hoveredSegment_ && !boxHandle_ && !inSelection) {
        drag_ = Drag::Box;
        return;
    }
    if (hoveredSegment_
        && !session.selection().contains(session.scene.lines().objectOf(*hoveredSegment_)))
        click(from_, bench);
    start(*app::findTransformation("move"), from_.raw, bench);
}

void SelectTool::start(const app::Transformation& kind, const app::Point& pointer, Workbench& bench)
{
    drag_ = Drag::Transform;
    transform_.start(kind, bench.session.pivot.at(), pointer, pointer, bench);
}

/// Begins a transformation that follows the pointer without a button.
void SelectTool::transform(const app::Transformation& kind, const Pointer& pointer,
                           Workbench& bench)
{
    if (busy() && !transform_.going())
        return; // a drag goes on
    cancel(bench);
    forgetSteps(bench);
    bench.session.guide.reset();
    forgetHovered();
    const app::Point pivot = bench.session.pivot.at();
    transform_.start(kind, pivot, pointer.raw,
                     TransformGesture::grabbedAt(pointer.raw, pivot, bench), bench);
}

std::optional<app::Gauge> SelectTool::gauge(const Workbench& bench) const
{
    if (choosesGuide(bench))
        return guide_.gauge(bench);
    if (end_.going() || end_.canReopen(bench))
        return end_.gauge(bench);
    if (resize_.going() || resize_.canReopen(bench))
        return resize_.gauge(bench);
    return transform_.gauge(bench);
}

void SelectTool::accept(const app::GestureEnd& end, Workbench& bench)
{
    drag_ = Drag::None;
    if (end_.going())
        return end_.accept(end.point, bench);
    if (choosesGuide(bench))
        return guide_.accept(end.point, bench);
    resize_.going() ? resize_.accept(end, bench) : transform_.accept(end, bench);
}

void SelectTool::release(const Pointer& pointer, Workbench& bench)
{
    if (gesture_.going()) {
        gesture_.finish(pointer, bench);
        return;
    }
    if (guide_.going())
        return guide_.finish(bench);
    if (end_.going()) {
        if (!end_.finish(pointer, bench))
            click(pointer, bench);
        return;
    }
    if (drag_ == Drag::None)
        return;
    move(pointer, bench); // it may begin the drag
    const Drag drag = std::exchange(drag_, Drag::None);
    if (drag == Drag::Press)
        click(from_, bench);
    else if (drag == Drag::Box)
        selectBox(pointer, bench);
    else if (drag == Drag::Resize)
        resize_.finish(bench);
    else if (drag == Drag::Transform)
        transform_.finish(bench);
    hoveredSegment_.reset();
    lookNear(pointer, bench);
}

/// Enters a group, edits a text, or shows the nodes of a path; beside all objects it leaves the
/// group.
void SelectTool::doubleClick(const Pointer& pointer, Workbench& bench)
{
    const auto object = pickedAt(pointer.raw, bench).object;
    if (!object && bench.session.entered.id() != 0)
        return leaveGroup(bench.session);
    if (!object)
        return press(pointer, bench);
    if (openAt(*object, bench))
        return;
    bench.session.select({*object});
    bench.nextTool = "nodes";
}

void SelectTool::click(const Pointer& pointer, Workbench& bench)
{
    const auto [segment, object] = pickedAt(pointer.raw, bench);
    if (!object)
        refuseLocked(pointer, bench);
    const bool chosen = choose(object, pointer.modifiers, bench.session);
    bench.session.inspect(chosen ? segment : app::lineOfOnlyObject(bench.session));
}

/// Dragged from left to right the box selects what it contains, from right to left what it touches.
app::Picking::Box SelectTool::how(const Pointer& pointer) const
{
    return pointer.screen.x >= from_.screen.x ? app::Picking::Box::Contains
                                              : app::Picking::Box::Touches;
}

void SelectTool::selectBox(const Pointer& pointer, Workbench& bench)
{
    auto found = app::unitsOf(
        bench.session, bench.picking.objectsIn(app::between(from_.raw, pointer.raw), how(pointer)),
        how(pointer) == app::Picking::Box::Contains ? app::FoundGroups::Whole
                                                    : app::FoundGroups::Any);
    if (pointer.modifiers & Qt::ShiftModifier)
        found = united(found, bench.session.selection());
    bench.session.select(std::move(found));
    bench.session.inspect(app::lineOfOnlyObject(bench.session)); // as if it had been clicked
}

bool SelectTool::key(QKeyEvent& event, Workbench& bench)
{
    app::Session& session = bench.session;
    if (transform_.key(event, bench))
        return true;
    const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    if (enter && transform_.going()) {
        drag_ = Drag::None;
        transform_.finish(bench);
        return true;
    }
    if (deletes(event) && choosesGuide(bench)) {
        GuideDrag::remove(*session.guide, bench);
        return true;
    }
    if (event.key() == Qt::Key_Escape && choosesGuide(bench)) {
        session.guide.reset();
        return true;
    }
    if (!deletes(event) || session.selection().empty() || busy())
        return false;
    session.history.push(new app::RemoveObjects(session.document, session.selection()));
    hoveredSegment_.reset();
    return true;
}

// A hint about the hovered object, else about the selection.
QString SelectTool::hint(const Workbench& bench) const
{
    const app::Session& session = bench.session;
    if (const QString hint = transform_.hint(bench); !hint.isEmpty())
        return hint;
    if (const QString hint = PivotMarks::hint(mark_); !hint.isEmpty() && drag_ == Drag::None)
        return hint;
    if (!busy() && (end_.canReopen(bench) || resize_.canReopen(bench)))
        return Text::tr("Enter, then another number: change this step.");
    if (hoveredEnd_ || end_.going())
        return Text::tr(
            "Drag the end of the line, or type a length, Tab, an angle, Enter. Shift: 15° "
            "steps, Alt: from the middle.");
    if (const QString hint = guide_.hint(bench); !hint.isEmpty())
        return hint;
    if (const auto number = session.windowNumber(); number && hoveredHandle_ && !busy())
        return handleHint(*hoveredHandle_).arg(app::nameOf(session.windows().list[*number]));
    if (hoveredGuide_)
        return Text::tr("Drag the guide, or click it and press "
                        "Enter to type its position.");
    if (hoveredSegment_ && *hoveredSegment_ < session.scene.lines().size() && drag_ == Drag::None) {
        const app::Containers& containers = session.now().containers();
        const std::size_t number = session.scene.lines().objectOf(*hoveredSegment_);
        const auto layer = containers.layerOf(number);
        if (const app::ContainerId group = app::groupAt(session, number))
            return Text::tr("%1 of %2 objects in %3. Click: select, double click: enter, "
                            "Alt+click: one object.")
                .arg(app::groupName(containers[group]),
                     app::countText(containers.rangeOf(group).size()), containers[layer].name);
        const app::ObjectView object = session.now().objects()[number];
        const QString name = object.singleLine() && object.particulars().id.isEmpty()
                                 ? Text::tr("Line %1").arg(app::countText(*hoveredSegment_ + 1))
                                 : app::nameOf(object);
        return Text::tr("%1 in %2. Click: select, drag: move, double click: show its nodes.")
            .arg(name, containers[layer].name);
    }
    if (!session.selection().empty())
        return Text::tr("%1 selected. Drag or arrow keys: move. G, O, K: move, "
                        "rotate, scale by numbers. Delete: remove.")
            .arg(app::countText(session.selection().size()));
    if (const auto line = session.inspected())
        return Text::tr("The Line panel shows line %1. Click a line to select it.")
            .arg(app::countText(*line + 1));
    return {};
}

QCursor SelectTool::cursor(const Workbench&) const
{
    if (hoveredHandle_ || gesture_.going())
        return cursorOf(hoveredHandle_.value_or(app::Handle{}));
    if (mark_ != Mark::None)
        return Qt::PointingHandCursor;
    if (hoveredGuide_ || guide_.going())
        return Qt::SizeAllCursor;
    if (boxHandle_)
        return cursorOf(*boxHandle_);
    return hoveredEnd_ || end_.going() || transform_.going() ? Qt::SizeAllCursor : Qt::ArrowCursor;
}

void SelectTool::paint(QPainter& painter, const Workbench& bench) const
{
    end_.paint(painter, bench);
    guide_.paint(painter, bench);
    if (drag_ == Drag::Box)
        paintSelectionBox(painter, bench, from_.raw, to_.raw,
                          how(to_) == app::Picking::Box::Touches ? Qt::DashLine : Qt::SolidLine);
    if (resize_.going())
        resize_.paint(painter, bench);
    transform_.paint(painter, bench);
    const auto box = boxAround(bench.session);
    if (box && !transform_.going())
        SelectionMarks::paint(painter, bench, resize_.going() ? resize_.target() : *box, near_);
    if (!resize_.going() && !end_.going() && !transform_.going())
        PivotMarks::paint(painter, bench, near_);
}

} // namespace

std::unique_ptr<Tool> makeSelectTool() { return std::make_unique<SelectTool>(); }

} // namespace ui

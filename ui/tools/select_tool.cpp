// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/keys_in_use.h"
#include "app/base/numbers.h"
#include "app/commands/add_and_remove.h"
#include "app/session/inspection.h"
#include "app/session/units.h"
#include "ui/look/text.h"
#include "ui/tools/box_drag.h"
#include "ui/tools/box_resize.h"
#include "ui/tools/group_choice.h"
#include "ui/tools/guide_drag.h"
#include "ui/tools/select_hover.h"
#include "ui/tools/selection_marks.h"
#include "ui/tools/shape_drawing.h"
#include "ui/tools/tool_of_drags.h"
#include "ui/tools/transform_gesture.h"
#include "ui/tools/window_gesture.h"

#include <utility>

namespace ui {
namespace {

bool deletes(const QKeyEvent& event)
{
    return event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace;
}

/// Dragged from left to right the box selects what it contains, from right to left what it touches.
void selectObjects(const Pointer& from, const Pointer& to, Workbench& bench)
{
    using Box = app::Picking::Box;
    app::Session& session = bench.session;
    const Box how = to.screen.x >= from.screen.x ? Box::Contains : Box::Touches;
    auto found =
        app::unitsOf(session, bench.picking.objectsIn(app::between(from.raw, to.raw), how),
                     how == Box::Contains ? app::FoundGroups::Whole : app::FoundGroups::Any);
    if (to.modifiers & Qt::ShiftModifier)
        found = united(found, session.selection());
    session.select(std::move(found));
    session.inspect(app::lineOfOnlyObject(session)); // as if it had been clicked
}

/// Selects objects by clicks and boxes, and drags them; also drags the clip window by its handles
/// and outline. A press on a handle begins its drag, any other one only when the pointer moves.
class SelectTool final : public ToolOfDrags, public TakesKeys, public Hovers, public Transforms {
public:
    SelectTool() : ToolOfDrags({&end_, &guide_, &box_, &resize_, &transform_, &pivot_, &window_}) {}
    void press(const Pointer& pointer, Workbench& bench) override;
    void release(const Pointer& pointer, Workbench& bench) override
    {
        const bool drags = pressed_.has_value();
        ToolOfDrags::release(pointer, bench);
        if (!drags)
            return;
        hover_.segment.reset();
        hover_.lookNear(pointer, bench);
    }
    void doubleClick(const Pointer& pointer, Workbench& bench) override;
    void leave(Workbench&) override
    {
        if (!busy())
            hover_ = {};
    }
    bool key(QKeyEvent& event, Workbench& bench) override;
    bool wants(const QKeyEvent& event, const Workbench& bench) const override
    {
        return transform_.wants(event) || (deletes(event) && choosesGuide(bench));
    }
    void transform(const app::Transformation& kind, const Pointer& pointer,
                   Workbench& bench) override;
    bool movesSelection() const override { return pressed_ && transform_.moves(); }
    std::optional<app::Gauge> gauge(const Workbench& bench) const override
    {
        if (window_.going())
            return std::nullopt; // it takes numbers with its own tool
        return choosesGuide(bench) ? guide_.gauge(bench) : ToolOfDrags::gauge(bench);
    }
    void accept(const app::GestureEnd& end, Workbench& bench) override
    {
        choosesGuide(bench) ? guide_.accept(end, bench) : ToolOfDrags::accept(end, bench);
        pressed_.reset();
    }
    std::optional<app::Handle> hoveredHandle() const override { return hover_.window; }
    std::optional<std::size_t> hoveredSegment() const override { return hover_.segment; }
    QCursor cursor(const Workbench& bench) const override
    {
        const QCursor hovered = hover_.cursor(bench.session);
        const bool drags = transform_.going() || end_.going() || guide_.going();
        return drags && hovered.shape() == Qt::ArrowCursor ? Qt::SizeAllCursor : hovered;
    }
    QString hint(const Workbench& bench) const override;
    void paint(QPainter& painter, const Workbench& bench) const override;

protected:
    void look(const Pointer& pointer, Workbench& bench) override { hover_.look(pointer, bench); }
    void startDrag(Workbench& bench) override;
    void click(const Pointer& pointer, Workbench& bench) override;

private:
    using Mark = PivotMarks::Mark;

    /// Whether numbers and Delete are for a guide.
    bool choosesGuide(const Workbench& bench) const
    {
        return guide_.going() || (!busy() && GuideDrag::chosen(bench));
    }
    void start(std::string_view kind, Workbench& bench)
    {
        const app::Point& at = pressed_->raw;
        transform_.start(*app::findTransformation(kind), bench.session.pivot.at(), at, at, bench);
    }

    SelectHover hover_;
    WindowGesture window_;
    EndDrag end_;
    GuideDrag guide_;
    BoxResize resize_;
    TransformGesture transform_;
    PivotDrag pivot_;
    BoxDrag box_{selectObjects, Qt::DashLine};
};

void SelectTool::press(const Pointer& pointer, Workbench& bench)
{
    if (transform_.going() && !transform_.corrects()) // begun by a key
        return void(transform_.finish(pointer, bench));
    forgetSteps(bench);
    bench.session.guide.reset();
    hover_.look(pointer, bench);
    pressed_ = pointer;
    if (hover_.window)
        window_.start(*hover_.window, pointer, bench);
    else if (hover_.guide)
        guide_.start(*hover_.guide, bench);
    else if (hover_.end)
        end_.start(*hover_.end, pointer, bench);
}

// In the area of an unselected object the drag draws a selection box; otherwise a background could
// not be dragged across.
void SelectTool::startDrag(Workbench& bench)
{
    if (hover_.isHandle())
        return; // its drag was cancelled
    const app::Session& session = bench.session;
    if (hover_.mark == Mark::Rotation)
        return start("rotate", bench);
    if (hover_.mark == Mark::Pivot)
        return pivot_.start();
    if (hover_.box.value_or(app::Handle{}) != app::Handle{})
        return resize_.start({*hover_.box, *handledFrame(session)}, *pressed_, bench);
    const auto area = bench.picking.areaAt(pressed_->raw);
    const bool inSelection = area && session.selection().contains(*area);
    if (!hover_.segment && !hover_.box && !inSelection)
        return box_.start(*pressed_);
    if (hover_.segment
        && !session.selection().contains(session.scene.lines().objectOf(*hover_.segment)))
        click(*pressed_, bench);
    start("move", bench);
}

/// Begins a transformation that follows the pointer without a button.
void SelectTool::transform(const app::Transformation& kind, const Pointer& pointer,
                           Workbench& bench)
{
    if (busy() && !transform_.going())
        return; // a drag goes on
    pressed_.reset();
    forgetSteps(bench);
    bench.session.guide.reset();
    hover_ = {};
    const app::Point pivot = bench.session.pivot.at();
    transform_.start(kind, pivot, pointer.raw,
                     TransformGesture::grabbedAt(pointer.raw, pivot, bench), bench);
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

bool SelectTool::key(QKeyEvent& event, Workbench& bench)
{
    app::Session& session = bench.session;
    const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    if (transform_.key(event, bench))
        return true;
    if (enter && transform_.going()) {
        pressed_.reset();
        transform_.finish(bench);
    } else if (deletes(event) && choosesGuide(bench)) {
        GuideDrag::remove(*session.guide, bench);
    } else if (event.key() == Qt::Key_Escape && choosesGuide(bench)) {
        session.guide.reset();
    } else if (deletes(event) && !session.selection().empty() && !busy()) {
        session.history.push(new app::RemoveObjects(session.document, session.selection()));
        hover_.segment.reset();
    } else {
        return false;
    }
    return true;
}

// A hint about the hovered object, else about the selection.
QString SelectTool::hint(const Workbench& bench) const
{
    const app::Session& session = bench.session;
    if (const QString hint = transform_.hint(bench); !hint.isEmpty())
        return hint;
    if (const QString hint = PivotMarks::hint(hover_.mark); !hint.isEmpty() && !busy())
        return hint;
    if (!busy() && (end_.canReopen(bench) || resize_.canReopen(bench)))
        return Text::tr("Enter, then another number: change this step.");
    if (hover_.end || end_.going())
        return Text::tr(
            "Drag the end of the line, or type a length, Tab, an angle, Enter. Shift: 15° "
            "steps, Alt: from the middle.");
    if (const QString hint = guide_.hint(bench); !hint.isEmpty())
        return hint;
    if (const QString hint = hover_.hint(bench); !hint.isEmpty() && !busy())
        return hint;
    if (!session.selection().empty())
        return app::withKeys(Text::tr("%1 selected. Drag or arrow keys: move. {move}, {rotate}, "
                                      "{scale}: move, rotate, scale by numbers."))
            .arg(app::selectionText(session));
    if (const auto line = session.inspected())
        return Text::tr("The Line panel shows line %1. Click a line to select it.")
            .arg(app::countText(*line + 1));
    return {};
}

void SelectTool::paint(QPainter& painter, const Workbench& bench) const
{
    ToolOfDrags::paint(painter, bench);
    const auto frame = handledFrame(bench.session);
    if (frame && !transform_.going())
        SelectionMarks::paint(painter, bench, resize_.going() ? resize_.target() : *frame,
                              hover_.near);
    if (!resize_.going() && !end_.going() && !transform_.going())
        PivotMarks::paint(painter, bench, hover_.near);
}

} // namespace

std::unique_ptr<Tool> makeSelectTool() { return std::make_unique<SelectTool>(); }

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/commands/add_and_remove.h"
#include "ui/look/text.h"
#include "ui/tools/box_drag.h"
#include "ui/tools/group_choice.h"
#include "ui/tools/node_drag.h"
#include "ui/tools/picking_marks.h"
#include "ui/tools/shape_drawing.h"
#include "ui/tools/tool_of_drags.h"

#include <utility>

namespace ui {
namespace {

/// Without shown nodes, the objects that the box touches.
void selectNodes(const Pointer& from, const Pointer& to, Workbench& bench)
{
    app::Session& session = bench.session;
    const clipping::Window box = app::between(from.raw, to.raw);
    if (session.selection().empty())
        return session.select(bench.picking.objectsIn(box, app::Picking::Box::Touches));
    session.nodes.select([&](app::NodePath& path) {
        if (!(to.modifiers & Qt::ShiftModifier))
            app::selectAll(path, false);
        app::selectWithin(path, box);
    });
}

/// Shows the nodes of the selected objects; selects, moves and adds nodes, and moves handles. What
/// else can be done with nodes are commands (app/nodes/node_steps.h).
class NodesTool final : public ToolOfDrags,
                        public TakenUp,
                        public TakesKeys,
                        public Hovers,
                        public SelectsForMenu {
public:
    NodesTool() : ToolOfDrags({&box_, &nodes_}) {}
    void takeUp(Workbench& bench) override
    {
        bench.session.inspect(std::nullopt); // its marks would cover the nodes
        bench.session.nodes.setShown(true);
    }
    void putAway(Workbench& bench) override { bench.session.nodes.setShown(false); }

    void press(const Pointer& pointer, Workbench& bench) override;
    void move(const Pointer& pointer, Workbench& bench) override
    {
        cancelOutdated(bench);
        ToolOfDrags::move(pointer, bench);
    }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        cancelOutdated(bench);
        ToolOfDrags::release(pointer, bench);
    }
    void doubleClick(const Pointer& pointer, Workbench& bench) override;
    bool selectForMenu(const Pointer& pointer, Workbench& bench) override;
    bool key(QKeyEvent& event, Workbench& bench) override;
    void leave(Workbench&) override
    {
        if (!busy())
            hovered_ = {};
    }
    std::optional<app::Gauge> gauge(const Workbench& bench) const override;
    void accept(const app::GestureEnd& end, Workbench& bench) override;
    void limit(app::SnapQuery& query) const override
    {
        if (going() || !pressed_)
            ToolOfDrags::limit(query);
    }
    QCursor cursor(const Workbench&) const override
    {
        const bool moves = hovered_.point.node || hovered_.point.handle || nodes_.going();
        return moves ? Qt::SizeAllCursor : Qt::ArrowCursor;
    }
    std::optional<std::size_t> hoveredSegment() const override { return hovered_.segment; }
    QString hint(const Workbench& bench) const override;
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (!nodes_.going())
            paintNodes(painter, bench, bench.session.nodes.path(), hovered_.point);
        ToolOfDrags::paint(painter, bench);
    }

protected:
    void look(const Pointer& pointer, Workbench& bench) override;
    void startDrag(Workbench& bench) override;
    void click(const Pointer& pointer, Workbench& bench) override;

private:
    /// Whether the nodes under the gesture may be others by now, for example after a deletion.
    bool outdated(const Workbench& bench) const
    {
        return busy() && bench.session.nodes.revision() != revision_;
    }
    void cancelOutdated(Workbench& bench)
    {
        if (outdated(bench))
            cancel(bench);
    }
    void clickObject(const Pointer& pointer, Workbench& bench);
    bool arrow(const QKeyEvent& event, Workbench& bench);

    struct {
        HoveredNode point;
        std::optional<std::size_t> segment; ///< of the scene
    } hovered_;
    GrabbedNodes grabbed_;
    BoxDrag box_{selectNodes};
    NodeDrag nodes_;
    std::uint64_t revision_ = 0; ///< of the nodes at the press
    bool isNew_ = false;         ///< the last click has chosen another object
};

void NodesTool::look(const Pointer& pointer, Workbench& bench)
{
    hovered_ = {GrabbedNodes::at(pointer, bench).point, {}};
    if (!hovered_.point.node && !hovered_.point.handle)
        hovered_.segment = bench.picking.nearest(pointer.raw, bench.inDrawing(reach));
}

void NodesTool::press(const Pointer& pointer, Workbench& bench)
{
    app::NodeEditing& nodes = bench.session.nodes;
    look(pointer, bench);
    grabbed_ = GrabbedNodes::at(pointer, bench);
    if (const auto& node = grabbed_.point.node;
        node && !nodeOf(*node, bench).selected && !(pointer.modifiers & Qt::ShiftModifier))
        nodes.selectOnly(*node);
    pressed_ = pointer;
    isNew_ = false;
    revision_ = nodes.revision();
}

void NodesTool::startDrag(Workbench& bench)
{
    hovered_.segment.reset();
    if (grabbed_.isNothing())
        return box_.start(*pressed_);
    if (!grabbed_.isCurved(bench) && !grabbed_.areSelected(bench))
        grabbed_.select(grabbed_.segment ? pressed_->modifiers : Qt::ShiftModifier, bench);
    nodes_.start(grabbed_, *pressed_, bench);
}

/// Adds a node where the path was clicked. A text is edited instead; and where the first of the two
/// clicks has only chosen the object, its group is entered, or its nodes are shown.
void NodesTool::doubleClick(const Pointer& pointer, Workbench& bench)
{
    app::NodeEditing& nodes = bench.session.nodes;
    const auto object = pickedAt(pointer.raw, bench).object;
    const bool isNew = std::exchange(isNew_, false);
    if (object && (isNew || isText(bench.session, *object)) && openAt(*object, bench))
        return;
    if (const auto at = GrabbedNodes::at(pointer, bench).segment; at && !isNew)
        nodes.insert(at->segment, at->t);
    else
        press(pointer, bench);
}

/// A node or a segment; beside the paths whose nodes are shown, another object.
bool NodesTool::selectForMenu(const Pointer& pointer, Workbench& bench)
{
    press(pointer, bench); // selects a node, unless it is selected
    cancel(bench);
    if (grabbed_.segment && !grabbed_.areSelected(bench))
        click(pointer, bench);
    if (!grabbed_.isNothing())
        return true;
    const auto object = pickedAt(pointer.raw, bench).object;
    if (object && !bench.session.selection().contains(*object))
        clickObject(pointer, bench);
    return object.has_value();
}

void NodesTool::click(const Pointer& pointer, Workbench& bench)
{
    grabbed_.isNothing() ? clickObject(pointer, bench) : grabbed_.select(pointer.modifiers, bench);
}

/// Shows the nodes of another object. Beside all objects, first nodes are deselected, then objects.
void NodesTool::clickObject(const Pointer& pointer, Workbench& bench)
{
    app::Session& session = bench.session;
    const auto object = pickedAt(pointer.raw, bench).object;
    const bool adds = pointer.modifiers & Qt::ShiftModifier;
    if (object && !session.selection().contains(*object)) {
        isNew_ = true;
        auto selection = adds ? session.selection() : app::ObjectRanges{};
        selection.insert(*object);
        session.select(std::move(selection));
    } else if (session.nodes.someSelected() && !adds) {
        session.nodes.selectAll(false);
    } else if (!object && !adds) {
        session.select({});
    }
}

bool NodesTool::arrow(const QKeyEvent& event, Workbench& bench)
{
    const bool others = event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier);
    const auto direction =
        app::Point(int(event.key() == Qt::Key_Right) - int(event.key() == Qt::Key_Left),
                   int(event.key() == Qt::Key_Down) - int(event.key() == Qt::Key_Up));
    if (others || direction == app::Point(0) || !bench.session.nodes.someSelected())
        return false;
    bench.session.nodes.move(direction * nudge(bench, event.modifiers()), app::Merging::WithLast);
    return true;
}

bool NodesTool::key(QKeyEvent& event, Workbench& bench)
{
    app::NodeEditing& nodes = bench.session.nodes;
    if (busy())
        return false;
    switch (event.key()) {
    case Qt::Key_Escape:
        nodes.someSelected() ? nodes.selectAll(false) : void(bench.nextTool = "select");
        return true;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        if ((event.modifiers() & ~Qt::ShiftModifier) || nodes.summary().nodes == 0)
            return false;
        nodes.selectNeighbour(event.key() == Qt::Key_Tab);
        return true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        if (!nodes.someSelected())
            return false;
        nodes.run(app::nodeStep("delete-nodes"));
        return true;
    default:
        return arrow(event, bench);
    }
}

std::optional<app::Gauge> NodesTool::gauge(const Workbench& bench) const
{
    if (outdated(bench))
        return std::nullopt;
    const auto only = busy() ? std::nullopt : bench.session.nodes.summary().only;
    if (!only)
        return ToolOfDrags::gauge(bench);
    const app::Point at = nodeOf(*only, bench).at;
    app::Gauge gauge = gaugeOfStart(bench);
    gauge.relativeTo = at;
    gauge.aim = app::GestureEnd{at, gauge.measure->values(gauge.start, at)};
    return gauge;
}

void NodesTool::accept(const app::GestureEnd& end, Workbench& bench)
{
    if (outdated(bench))
        return cancel(bench);
    const auto only = busy() ? std::nullopt : bench.session.nodes.summary().only;
    if (only)
        bench.session.nodes.moveTo(*only, end.point);
    else
        ToolOfDrags::accept(end, bench);
}

QString NodesTool::hint(const Workbench& bench) const
{
    const app::NodeSummary& nodes = bench.session.nodes.summary();
    if (nodes.nodes == 0)
        return {};
    if (nodes.selected == 0)
        return Text::tr(
                   "%1 nodes. Click one, drag a box, or press Tab. Double click on the path adds "
                   "one.")
            .arg(app::countText(nodes.nodes));
    if (nodes.only) {
        const app::Gauge gauge = gaugeOfStart(bench);
        const app::Point spot = nodeOf(*nodes.only, bench).at, at = spot - gauge.origin;
        const auto number = [&](double value) {
            return app::lengthText(value, gauge.scale.unit, gauge.scale.millimetresPerUnit);
        };
        if (const auto count = app::nodesOn(bench.session.nodes.path(), spot); count > 1)
            return Text::tr("%1 nodes on one spot, at x %2, y %3. A box around it selects all.")
                .arg(app::countText(count), number(at.x), number(at.y));
        return Text::tr("1 of %1 nodes, at x %2, y %3. Drag it, or Enter and x,y. Delete keeps the "
                        "shape.")
            .arg(app::countText(nodes.nodes), number(at.x), number(at.y));
    }
    return Text::tr("%1 of %2 nodes. Dragging or the arrow keys move them; Delete keeps the shape.")
        .arg(app::countText(nodes.selected), app::countText(nodes.nodes));
}

} // namespace

std::unique_ptr<Tool> makeNodesTool() { return std::make_unique<NodesTool>(); }

} // namespace ui

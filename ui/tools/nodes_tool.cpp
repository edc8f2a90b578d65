// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/commands/add_and_remove.h"
#include "app/document/direction.h"
#include "app/nodes/fixed_parts.h"
#include "ui/look/text.h"
#include "ui/tools/group_choice.h"
#include "ui/tools/node_painter.h"
#include "ui/tools/picking_marks.h"
#include "ui/tools/shape_drawing.h"

#include <glm/geometric.hpp>

#include <array>
#include <utility>

namespace ui {
namespace {

constexpr double nodeReach = 8; // pixels

/// Shows the nodes of the selected objects; selects, moves and adds nodes, and moves handles. What
/// else can be done with nodes are commands (app/nodes/node_steps.h).
class NodesTool final : public Tool,
                        public TakenUp,
                        public TakesKeys,
                        public TypesNumbers,
                        public Snaps,
                        public Hovers,
                        public SelectsForMenu {
public:
    void takeUp(Workbench& bench) override
    {
        bench.session.inspect(std::nullopt); // its marks would cover the nodes
        bench.session.nodes.setShown(true);
    }
    void putAway(Workbench& bench) override { bench.session.nodes.setShown(false); }

    void press(const Pointer& pointer, Workbench& bench) override;
    void move(const Pointer& pointer, Workbench& bench) override;
    void release(const Pointer& pointer, Workbench& bench) override;
    void doubleClick(const Pointer& pointer, Workbench& bench) override;
    bool selectForMenu(const Pointer& pointer, Workbench& bench) override;
    bool key(QKeyEvent& event, Workbench& bench) override;
    void leave(Workbench&) override
    {
        if (!busy())
            forgetHovered();
    }
    void cancel(Workbench&) override
    {
        preview_.reset();
        grabbed_ = {};
        drag_ = Drag::None;
    }
    bool busy() const override { return drag_ != Drag::None; }

    std::optional<app::Gauge> gauge(const Workbench& bench) const override;
    void accept(const app::GestureEnd& end, Workbench& bench) override;

    QCursor cursor(const Workbench&) const override
    {
        return hovered_.node || hovered_.handle || preview_ ? Qt::SizeAllCursor : Qt::ArrowCursor;
    }
    void limit(app::SnapQuery& query) const override
    {
        if (!preview_ && drag_ != Drag::Press)
            query.to = app::SnapTo::Nothing;
        if (!preview_)
            return;
        query.without = moving_;
        query.parts = &fixed_;
    }
    std::optional<std::size_t> hoveredSegment() const override { return hoveredSegment_; }
    QString hint(const Workbench& bench) const override;
    void paint(QPainter& painter, const Workbench& bench) const override;

private:
    enum class Drag : std::uint8_t { None, Press, Box, Nodes, Handle, Bend };
    /// What was under the pointer at the press.
    struct Grabbed {
        HoveredNode point{};
        std::optional<app::SegmentPoint> segment{};
    };

    /// Whether the nodes under the gesture may be others by now, for example after a deletion.
    bool outdated(const Workbench& bench) const
    {
        return busy() && bench.session.nodes.revision() != revision_;
    }
    void forgetHovered()
    {
        hovered_ = {};
        hoveredSegment_.reset();
    }
    static HoveredNode nodeUnder(const Pointer& pointer, const Workbench& bench);
    void lookUnder(const Pointer& pointer, Workbench& bench);
    void startDrag(Workbench& bench);
    void follow(const app::Point& to, Workbench& bench);
    void findFixed(Workbench& bench);
    void push(Workbench& bench);
    void choose(std::span<const app::NodeAddress> chosen, Workbench& bench);
    void click(Workbench& bench);
    void clickObject(const Pointer& pointer, Workbench& bench);
    void selectBox(const Pointer& pointer, Workbench& bench);
    bool arrow(const QKeyEvent& event, Workbench& bench);
    const app::Node& nodeOf(const app::NodeAddress& address, const Workbench& bench) const
    {
        return bench.session.nodes.path()[address.subpath].nodes[address.node];
    }

    Drag drag_ = Drag::None;
    Grabbed grabbed_;
    HoveredNode hovered_;
    std::optional<std::size_t> hoveredSegment_; ///< of the scene
    std::optional<app::NodePath> preview_;      ///< the paths as the drag would leave them
    app::ObjectRanges moving_;                  ///< the objects that the drag changes,
    std::vector<app::Subpath> fixed_;           ///< and what stays of them
    std::uint64_t revision_ = 0;                ///< of the nodes at the press
    Pointer from_{}, to_{};
    bool isNew_ = false; ///< the last click has chosen another object
};

HoveredNode NodesTool::nodeUnder(const Pointer& pointer, const Workbench& bench)
{
    const app::NodePath& path = bench.session.nodes.path();
    const double radius = bench.inDrawing(nodeReach);
    const auto node = app::nodeAt(path, pointer.raw, radius);
    double nearest =
        node ? glm::distance(path[node->subpath].nodes[node->node].at, pointer.raw) : radius;
    HoveredNode found{node, {}};
    for (const app::ShownHandle& handle : handlesOf(path, bench))
        if (const double apart = glm::distance(handle.at, pointer.raw); apart < nearest) {
            nearest = apart;
            found = {{}, handle};
        }
    return found;
}

void NodesTool::lookUnder(const Pointer& pointer, Workbench& bench)
{
    hovered_ = nodeUnder(pointer, bench);
    hoveredSegment_ = hovered_.node || hovered_.handle
                          ? std::nullopt
                          : bench.picking.nearest(pointer.raw, bench.inDrawing(reach));
}

void NodesTool::press(const Pointer& pointer, Workbench& bench)
{
    app::NodeEditing& nodes = bench.session.nodes;
    lookUnder(pointer, bench);
    grabbed_ = {hovered_, {}};
    if (!hovered_.node && !hovered_.handle)
        grabbed_.segment = app::segmentAt(nodes.path(), pointer.raw, bench.inDrawing(reach));
    if (hovered_.node && !nodeOf(*hovered_.node, bench).selected
        && !(pointer.modifiers & Qt::ShiftModifier))
        nodes.selectOnly(*hovered_.node);
    from_ = to_ = pointer;
    isNew_ = false;
    drag_ = Drag::Press;
    revision_ = nodes.revision();
}

void NodesTool::move(const Pointer& pointer, Workbench& bench)
{
    if (outdated(bench))
        cancel(bench);
    if (drag_ == Drag::None)
        return lookUnder(pointer, bench);
    to_ = pointer;
    if (drag_ == Drag::Press && dragged(from_.screen, pointer))
        startDrag(bench);
    if (preview_)
        follow(pointer.position, bench);
}

void NodesTool::startDrag(Workbench& bench)
{
    app::NodeEditing& nodes = bench.session.nodes;
    hoveredSegment_.reset();
    drag_ = Drag::Box;
    if (const auto& node = grabbed_.point.node) {
        if (!nodeOf(*node, bench).selected)
            nodes.select([&](app::NodePath& path) {
                path[node->subpath].nodes[node->node].selected = true;
            });
        drag_ = Drag::Nodes;
    } else if (grabbed_.point.handle) {
        drag_ = Drag::Handle;
    } else if (grabbed_.segment) {
        const auto& [subpath, segment] = grabbed_.segment->segment;
        const app::NodeSubpath& of = nodes.path()[subpath];
        const bool curved = of.nodes[segment].curved;
        drag_ = curved ? Drag::Bend : Drag::Nodes;
        const bool together =
            of.nodes[segment].selected && of.nodes[(segment + 1) % of.nodes.size()].selected;
        if (!curved && !together)
            click(bench);
    }
    if (drag_ == Drag::Box)
        return;
    preview_ = nodes.path();
    findFixed(bench);
}

/// Finds what moves by moving it: handles take those opposite along, and a bent segment its ends'.
void NodesTool::findFixed(Workbench& bench)
{
    const app::NodeEditing& nodes = bench.session.nodes;
    follow(from_.raw + app::Point(bench.inDrawing(2 * dragDistance)), bench);
    moving_ = {};
    fixed_.clear();
    for (std::size_t i = 0; i < preview_->size(); ++i)
        if ((*preview_)[i] != nodes.path()[i])
            moving_.insert(nodes.objectOf(i));
    for (std::size_t i = 0; i < preview_->size(); ++i)
        if (moving_.contains(nodes.objectOf(i)))
            for (app::Subpath& part : app::fixedParts(nodes.path()[i], (*preview_)[i]))
                fixed_.push_back(std::move(part));
}

/// The paths as they are when what is dragged lies at `to`.
void NodesTool::follow(const app::Point& to, Workbench& bench)
{
    *preview_ = bench.session.nodes.path();
    if (drag_ == Drag::Handle) {
        const app::ShownHandle& handle = *grabbed_.point.handle;
        app::NodeSubpath& subpath = (*preview_)[handle.node.subpath];
        if (to_.modifiers & Qt::AltModifier)
            subpath.nodes[handle.node.node].type = app::NodeType::Corner;
        app::moveHandle(subpath, handle.node.node, handle.side, to);
    } else if (drag_ == Drag::Bend) {
        const app::SegmentPoint& grabbed = *grabbed_.segment;
        app::bendSegment((*preview_)[grabbed.segment.subpath], grabbed.segment.node,
                         std::clamp(grabbed.t, 0.1, 0.9), to - grabbed.at);
    } else if (const auto& node = grabbed_.point.node) {
        const bool steps = to_.modifiers & Qt::ShiftModifier;
        app::moveSelectedTo(*preview_, *node,
                            steps ? app::turnedToStep(nodeOf(*node, bench).at, to) : to);
    } else {
        app::moveSelected(*preview_, to - grabbed_.segment->at);
    }
}

void NodesTool::push(Workbench& bench)
{
    const QString done = drag_ == Drag::Handle ? Text::tr("Move handle")
                         : drag_ == Drag::Bend ? Text::tr("Bend segment")
                                               : Text::tr("Move nodes");
    app::NodePath changed = std::move(*preview_);
    cancel(bench);
    bench.session.nodes.apply(std::move(changed), done);
}

void NodesTool::release(const Pointer& pointer, Workbench& bench)
{
    to_ = pointer;
    if (outdated(bench))
        return cancel(bench);
    if (drag_ == Drag::Press)
        click(bench);
    else if (drag_ == Drag::Box)
        selectBox(pointer, bench);
    else if (preview_) {
        follow(pointer.position, bench);
        return push(bench);
    }
    cancel(bench);
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
    if (const HoveredNode under = nodeUnder(pointer, bench); isNew || under.node || under.handle)
        return press(pointer, bench);
    if (const auto at = app::segmentAt(nodes.path(), pointer.raw, bench.inDrawing(reach)))
        nodes.insert(at->segment, at->t);
    else
        press(pointer, bench);
}

/// A node or a segment; beside the paths whose nodes are shown, another object.
bool NodesTool::selectForMenu(const Pointer& pointer, Workbench& bench)
{
    press(pointer, bench); // selects a node, unless it is selected
    cancel(bench);
    const HoveredNode under = nodeUnder(pointer, bench);
    const app::NodePath& path = bench.session.nodes.path();
    const auto segment = app::segmentAt(path, pointer.raw, bench.inDrawing(reach));
    if (!under.node && !under.handle && segment) {
        const auto& nodes = path[segment->segment.subpath].nodes;
        const std::size_t first = segment->segment.node;
        if (!nodes[first].selected || !nodes[(first + 1) % nodes.size()].selected) {
            grabbed_.segment = segment;
            click(bench);
            cancel(bench);
        }
    } else if (!under.node && !under.handle) {
        const auto object = pickedAt(pointer.raw, bench).object;
        if (object && !bench.session.selection().contains(*object))
            clickObject(pointer, bench);
        return object.has_value();
    }
    return true;
}

/// With Shift, these nodes are selected beside the others; a single one is deselected again.
void NodesTool::choose(std::span<const app::NodeAddress> chosen, Workbench& bench)
{
    const bool adds = from_.modifiers & Qt::ShiftModifier;
    bench.session.nodes.select([&](app::NodePath& path) {
        if (!adds)
            app::selectAll(path, false);
        for (const auto& [subpath, node] : chosen) {
            bool& selected = path[subpath].nodes[node].selected;
            selected = chosen.size() > 1 || !selected;
        }
    });
}

void NodesTool::click(Workbench& bench)
{
    if (const auto& node = grabbed_.point.node)
        return choose(std::array{*node}, bench);
    if (grabbed_.point.handle)
        return;
    if (!grabbed_.segment)
        return clickObject(from_, bench);
    const auto [subpath, segment] = grabbed_.segment->segment;
    const std::size_t count = bench.session.nodes.path()[subpath].nodes.size();
    choose(std::array<app::NodeAddress, 2>{{{subpath, segment}, {subpath, (segment + 1) % count}}},
           bench);
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

void NodesTool::selectBox(const Pointer& pointer, Workbench& bench)
{
    app::Session& session = bench.session;
    const clipping::Window box = app::between(from_.raw, pointer.raw);
    if (session.selection().empty())
        return session.select(bench.picking.objectsIn(box, app::Picking::Box::Touches));
    session.nodes.select([&](app::NodePath& path) {
        if (!(pointer.modifiers & Qt::ShiftModifier))
            app::selectAll(path, false);
        app::selectWithin(path, box);
    });
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
    const auto atPosition = [&](const app::Point& node) {
        app::Gauge gauge = gaugeOfStart(bench);
        gauge.relativeTo = node;
        return gauge;
    };
    if (drag_ == Drag::Handle) {
        const app::NodeAddress& node = grabbed_.point.handle->node;
        return gaugeFrom(nodeOf(node, bench).at, app::lengthAndAngle(), bench);
    }
    if (drag_ == Drag::Nodes && grabbed_.point.node)
        return atPosition(nodeOf(*grabbed_.point.node, bench).at);
    if (drag_ == Drag::Nodes || drag_ == Drag::Bend) // how far
        return gaugeFrom(grabbed_.segment->at, app::lengthAndAngle(), bench);
    const auto only = drag_ == Drag::None ? bench.session.nodes.summary().only : std::nullopt;
    if (!only)
        return std::nullopt;
    app::Gauge gauge = atPosition(nodeOf(*only, bench).at);
    const app::Point at = nodeOf(*only, bench).at;
    gauge.aim = app::GestureEnd{at, gauge.measure->values(gauge.start, at)};
    return gauge;
}

void NodesTool::accept(const app::GestureEnd& end, Workbench& bench)
{
    const app::Point point = end.point;
    if (outdated(bench))
        return cancel(bench);
    if (preview_) {
        to_.modifiers = {};
        follow(point, bench);
        push(bench);
    } else if (const auto only = bench.session.nodes.summary().only) {
        bench.session.nodes.moveTo(*only, point);
    }
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
        const app::Point at = nodeOf(*nodes.only, bench).at - gauge.origin;
        const auto number = [&](double value) {
            return app::lengthText(value, gauge.scale.unit, gauge.scale.millimetresPerUnit);
        };
        return Text::tr(
                   "1 of %1 nodes, at x %2, y %3. Drag it, or press Enter and type x,y. Delete "
                   "keeps the shape.")
            .arg(app::countText(nodes.nodes), number(at.x), number(at.y));
    }
    return Text::tr("%1 of %2 nodes. Dragging or the arrow keys move them; Delete keeps the shape.")
        .arg(app::countText(nodes.selected), app::countText(nodes.nodes));
}

void NodesTool::paint(QPainter& painter, const Workbench& bench) const
{
    const app::NodePath& path = preview_ ? *preview_ : bench.session.nodes.path();
    if (preview_) {
        const auto dragged = grabbed_.segment        ? std::optional(grabbed_.segment->segment)
                             : grabbed_.point.handle ? std::optional(grabbed_.point.handle->node)
                                                     : std::nullopt;
        paintChangedSegments(painter, bench, path, dragged);
    }
    paintNodes(painter, bench, path, preview_ ? HoveredNode{} : hovered_);
    if (drag_ == Drag::Box)
        paintSelectionBox(painter, bench, from_.raw, to_.raw);
}

} // namespace

std::unique_ptr<Tool> makeNodesTool() { return std::make_unique<NodesTool>(); }

} // namespace ui

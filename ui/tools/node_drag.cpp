// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/node_drag.h"

#include "app/document/direction.h"
#include "app/nodes/fixed_parts.h"
#include "ui/look/text.h"
#include "ui/tools/shape_drawing.h"

#include <utility>

namespace ui {

void NodeDrag::start(const GrabbedNodes& grabbed, const Pointer& pressed, Workbench& bench)
{
    grabbed_ = grabbed;
    what_ = grabbed.point.handle      ? What::Handle
            : grabbed.isCurved(bench) ? What::Bend
                                      : What::Nodes;
    paths_ = bench.session.nodes.path();
    findFixed(pressed, bench);
}

/// Finds what moves by moving it: handles take those opposite along, and a bent segment its ends'.
void NodeDrag::findFixed(const Pointer& pressed, Workbench& bench)
{
    const app::NodeEditing& nodes = bench.session.nodes;
    follow(pressed.raw + app::Point(bench.inDrawing(2 * dragDistance)), pressed.modifiers, bench);
    moving_ = {};
    fixed_.clear();
    for (std::size_t i = 0; i < paths_->size(); ++i)
        if ((*paths_)[i] != nodes.path()[i])
            moving_.insert(nodes.objectOf(i));
    for (std::size_t i = 0; i < paths_->size(); ++i)
        if (moving_.contains(nodes.objectOf(i)))
            for (app::Subpath& part : app::fixedParts(nodes.path()[i], (*paths_)[i]))
                fixed_.push_back(std::move(part));
}

/// The paths as they are when what is dragged lies at `to`.
void NodeDrag::follow(const app::Point& to, Qt::KeyboardModifiers modifiers, Workbench& bench)
{
    *paths_ = bench.session.nodes.path();
    if (what_ == What::Handle) {
        const app::ShownHandle& handle = *grabbed_.point.handle;
        app::NodeSubpath& subpath = (*paths_)[handle.node.subpath];
        if (modifiers & Qt::AltModifier)
            subpath.nodes[handle.node.node].type = app::NodeType::Corner;
        app::moveHandle(subpath, handle.node.node, handle.side, to);
    } else if (what_ == What::Bend) {
        const app::SegmentPoint& grabbed = *grabbed_.segment;
        app::bendSegment((*paths_)[grabbed.segment.subpath], grabbed.segment.node,
                         std::clamp(grabbed.t, 0.1, 0.9), to - grabbed.at);
    } else if (const auto& node = grabbed_.point.node) {
        const bool steps = modifiers & Qt::ShiftModifier;
        app::moveSelectedTo(*paths_, *node,
                            steps ? app::turnedToStep(nodeOf(*node, bench).at, to) : to);
    } else {
        app::moveSelected(*paths_, to - grabbed_.segment->at);
    }
}

void NodeDrag::proceed(const Pointer& pointer, Workbench& bench)
{
    follow(pointer.position, pointer.modifiers, bench);
}

bool NodeDrag::finish(const Pointer& pointer, Workbench& bench)
{
    proceed(pointer, bench);
    push(bench);
    return true;
}

void NodeDrag::accept(const app::GestureEnd& end, Workbench& bench)
{
    follow(end.point, {}, bench);
    push(bench);
}

void NodeDrag::push(Workbench& bench)
{
    const QString done = what_ == What::Handle ? Text::tr("Move handle")
                         : what_ == What::Bend ? Text::tr("Bend segment")
                                               : Text::tr("Move nodes");
    app::NodePath changed = *std::exchange(paths_, std::nullopt);
    bench.session.nodes.apply(std::move(changed), done);
}

std::optional<app::Gauge> NodeDrag::gauge(const Workbench& bench) const
{
    if (const auto& handle = grabbed_.point.handle)
        return gaugeFrom(nodeOf(handle->node, bench).at, app::lengthAndAngle(), bench);
    if (grabbed_.segment) // how far
        return gaugeFrom(grabbed_.segment->at, app::lengthAndAngle(), bench);
    app::Gauge gauge = gaugeOfStart(bench);
    gauge.relativeTo = nodeOf(*grabbed_.point.node, bench).at;
    return gauge;
}

void NodeDrag::paint(QPainter& painter, const Workbench& bench) const
{
    if (!paths_)
        return;
    const auto dragged = grabbed_.segment        ? std::optional(grabbed_.segment->segment)
                         : grabbed_.point.handle ? std::optional(grabbed_.point.handle->node)
                                                 : std::nullopt;
    paintChangedSegments(painter, bench, *paths_, dragged);
    paintNodes(painter, bench, *paths_, {});
}

} // namespace ui

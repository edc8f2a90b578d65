// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/grabbed_nodes.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace ui {

constexpr double nodeReach = 8; // pixels

const app::Node& nodeOf(const app::NodeAddress& address, const Workbench& bench)
{
    return bench.session.nodes.path()[address.subpath].nodes[address.node];
}

GrabbedNodes GrabbedNodes::at(const Pointer& pointer, const Workbench& bench)
{
    const app::NodePath& path = bench.session.nodes.path();
    const double radius = bench.inDrawing(nodeReach);
    const auto node = app::nodeAt(path, pointer.raw, radius);
    double nearest = node ? glm::distance(nodeOf(*node, bench).at, pointer.raw) : radius;
    GrabbedNodes found{{node, {}}, {}};
    for (const app::ShownHandle& handle : handlesOf(path, bench))
        if (const double apart = glm::distance(handle.at, pointer.raw); apart < nearest) {
            nearest = apart;
            found.point = {{}, handle};
        }
    if (found.isNothing())
        found.segment = app::segmentAt(path, pointer.raw, bench.inDrawing(reach));
    return found;
}

std::vector<app::NodeAddress> GrabbedNodes::nodes(const Workbench& bench) const
{
    if (point.node)
        return {*point.node};
    if (!segment)
        return {};
    const auto [subpath, first] = segment->segment;
    const std::size_t count = bench.session.nodes.path()[subpath].nodes.size();
    return {{subpath, first}, {subpath, (first + 1) % count}};
}

bool GrabbedNodes::areSelected(const Workbench& bench) const
{
    return std::ranges::all_of(
        nodes(bench), [&](const app::NodeAddress& node) { return nodeOf(node, bench).selected; });
}

bool GrabbedNodes::isCurved(const Workbench& bench) const
{
    return segment && nodeOf(segment->segment, bench).curved;
}

void GrabbedNodes::select(Qt::KeyboardModifiers modifiers, Workbench& bench) const
{
    const auto chosen = nodes(bench);
    if (chosen.empty())
        return;
    bench.session.nodes.select([&](app::NodePath& path) {
        if (!(modifiers & Qt::ShiftModifier))
            app::selectAll(path, false);
        for (const auto& [subpath, node] : chosen) {
            bool& selected = path[subpath].nodes[node].selected;
            selected = chosen.size() > 1 || !selected;
        }
    });
}

} // namespace ui

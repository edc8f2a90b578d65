// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_path.h"

#include "app/base/finite.h"
#include "app/nodes/node_types.h"

#include <algorithm>
#include <cmath>

namespace app {

std::size_t NodeSubpath::segmentCount() const
{
    if (nodes.size() <= 1)
        return closed && !nodes.empty() && nodes[0].curved ? 1 : 0;
    return closed ? nodes.size() : nodes.size() - 1;
}

std::optional<std::size_t> NodeSubpath::next(std::size_t node) const
{
    if (node + 1 < nodes.size())
        return node + 1;
    return segmentCount() == nodes.size() ? std::optional<std::size_t>(0) : std::nullopt;
}

std::optional<std::size_t> NodeSubpath::previous(std::size_t node) const
{
    if (node > 0)
        return node - 1;
    return segmentCount() == nodes.size() ? std::optional(nodes.size() - 1) : std::nullopt;
}

bool NodeSubpath::curvedInto(std::size_t node) const
{
    const auto before = previous(node);
    return before && nodes[*before].curved;
}

Bezier NodeSubpath::segment(std::size_t node) const
{
    const Node& from = nodes[node];
    const Node& to = nodes[(node + 1) % nodes.size()];
    if (from.curved)
        return {from.at, from.out, to.in, to.at};
    const Point third = (to.at - from.at) / 3.0;
    return {from.at, from.at + third, to.at - third, to.at};
}

namespace {

NodeSubpath nodesOf(const Subpath& subpath)
{
    NodeSubpath nodes{{}, subpath.closed};
    nodes.nodes.reserve(subpath.segments.size() + 1);
    nodes.nodes.push_back({subpath.start, subpath.start, subpath.start});
    for (const PathSegment& segment : subpath.segments) {
        Node& last = nodes.nodes.back();
        last.curved = segment.curved;
        if (segment.curved)
            last.out = segment.control1;
        nodes.nodes.push_back(
            {segment.to, segment.curved ? segment.control2 : segment.to, segment.to});
    }
    if (subpath.closed && nodes.nodes.size() > 1 && nodes.nodes.back().at == subpath.start) {
        if (!subpath.segments.empty() && subpath.segments.back().curved)
            nodes.nodes.front().in = nodes.nodes.back().in;
        nodes.nodes.pop_back();
    }
    for (std::size_t i = 0; i < nodes.nodes.size(); ++i)
        nodes.nodes[i].type = typeOf(nodes, i);
    return nodes;
}

Subpath subpathOf(const NodeSubpath& nodes)
{
    Subpath subpath{nodes.nodes.front().at, {}, nodes.closed};
    subpath.segments.reserve(nodes.segmentCount());
    for (std::size_t i = 0; i < nodes.segmentCount(); ++i) {
        const Node& from = nodes.nodes[i];
        const Node& to = nodes.nodes[(i + 1) % nodes.nodes.size()];
        if (from.curved)
            subpath.segments.push_back({to.at, from.out, to.in, true});
        else if (i + 1 < nodes.nodes.size()) // a closed subpath returns by a line of itself
            subpath.segments.push_back({to.at});
    }
    return subpath;
}

template <class Holds>
std::size_t count(std::span<const NodeSubpath> path, const Holds& holds)
{
    std::size_t sum = 0;
    for (const NodeSubpath& subpath : path)
        sum += std::size_t(std::ranges::count_if(subpath.nodes, holds));
    return sum;
}

} // namespace

NodePath nodesOf(std::span<const Subpath> subpaths)
{
    NodePath path;
    path.reserve(subpaths.size());
    for (const Subpath& subpath : subpaths)
        path.push_back(nodesOf(subpath));
    return path;
}

std::vector<Subpath> subpathsOf(std::span<const NodeSubpath> path)
{
    std::vector<Subpath> subpaths;
    subpaths.reserve(path.size());
    for (const NodeSubpath& nodes : path)
        if (!nodes.nodes.empty())
            subpaths.push_back(subpathOf(nodes));
    return subpaths;
}

std::size_t nodeCount(std::span<const NodeSubpath> path)
{
    return count(path, [](const Node&) { return true; });
}

std::size_t selectedCount(std::span<const NodeSubpath> path)
{
    return count(path, [](const Node& node) { return node.selected; });
}

bool isFinite(std::span<const NodeSubpath> path)
{
    const auto bad = [](const Node& node) {
        return !isFinite(node.at) || !isFinite(node.in) || !isFinite(node.out);
    };
    return count(path, bad) == 0;
}

void selectAll(std::span<NodeSubpath> path, bool selected)
{
    for (NodeSubpath& subpath : path)
        for (Node& node : subpath.nodes)
            node.selected = selected;
}

} // namespace app

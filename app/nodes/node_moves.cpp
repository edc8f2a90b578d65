// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_moves.h"

#include "app/base/finite.h"
#include "app/nodes/node_types.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {

std::optional<Point> handleOf(const NodeSubpath& subpath, std::size_t node, HandleSide side)
{
    const Node& of = subpath.nodes[node];
    const bool in = side == HandleSide::In;
    if (in ? !subpath.curvedInto(node) : !of.curved)
        return std::nullopt;
    const Point& handle = in ? of.in : of.out;
    return handle != of.at ? std::optional(handle) : std::nullopt;
}

bool moveSelected(NodePath& path, const Point& by)
{
    if (!isFinite(by))
        return false;
    for (NodeSubpath& subpath : path) {
        bool any = false;
        for (Node& node : subpath.nodes)
            if (node.selected) {
                node.at += by;
                node.in += by;
                node.out += by;
                any = true;
            }
        if (any)
            alignAroundSelected(subpath);
    }
    return true;
}

bool moveSelectedTo(NodePath& path, const NodeAddress& address, const Point& to)
{
    const NodeSubpath& subpath = path[address.subpath];
    const Point from = subpath.nodes[address.node].at;
    if (!moveSelected(path, to - from))
        return false;
    Node& node = path[address.subpath].nodes[address.node];
    for (Point* handle : {&node.in, &node.out})
        if (*handle == node.at)
            *handle = to;
    node.at = to; // without rounding
    return true;
}

bool moveHandle(NodeSubpath& subpath, std::size_t i, HandleSide side, const Point& to)
{
    Node& node = subpath.nodes[i];
    const bool in = side == HandleSide::In;
    if (!isFinite(to) || (in ? !subpath.curvedInto(i) : !node.curved))
        return false;
    Point& moved = in ? node.in : node.out;
    Point& other = in ? node.out : node.in;
    const bool otherCurved = in ? node.curved : subpath.curvedInto(i);
    const auto across = in ? subpath.next(i) : subpath.previous(i);
    moved = to;
    if (node.type == NodeType::Corner || !across)
        return true;
    if (!otherCurved) {
        const Point line = withLength(node.at - subpath.nodes[*across].at, 1);
        if (line != Point(0))
            moved = node.at + line * std::max(0.0, glm::dot(to - node.at, line));
    } else if (node.type == NodeType::Symmetric) {
        other = node.at - (moved - node.at);
    } else if (moved != node.at) {
        const Point handle = other - node.at;
        other = node.at - withLength(moved - node.at, std::hypot(handle.x, handle.y));
    }
    return true;
}

bool bendSegment(NodeSubpath& subpath, std::size_t segment, double t, const Point& by)
{
    if (!(t > 0 && t < 1) || segment >= subpath.segmentCount() || !isFinite(by)
        || !subpath.nodes[segment].curved)
        return false;
    const std::size_t end = (segment + 1) % subpath.nodes.size();
    const Bezier curve = subpath.segment(segment);
    // The nearer handle moves more; together they move the point at t by exactly `by`.
    const double ease = t * t * (3 - 2 * t), s = 1 - t;
    return moveHandle(subpath, segment, HandleSide::Out,
                      curve.control1 + by * ((1 - ease) / (3 * t * s * s)))
           && moveHandle(subpath, end, HandleSide::In,
                         curve.control2 + by * (ease / (3 * t * t * s)));
}

std::optional<NodeAddress> neighbour(const NodePath& path, const std::optional<NodeAddress>& of,
                                     bool forwards)
{
    const std::size_t count = nodeCount(path);
    if (count == 0)
        return std::nullopt;
    std::size_t number = forwards ? 0 : count - 1;
    if (of) {
        std::size_t before = of->node;
        for (std::size_t i = 0; i < of->subpath; ++i)
            before += path[i].nodes.size();
        number = (before + (forwards ? 1 : count - 1)) % count;
    }
    NodeAddress address;
    while (number >= path[address.subpath].nodes.size())
        number -= path[address.subpath++].nodes.size();
    address.node = number;
    return address;
}

namespace {

/// Without rounding; a handle that lies on the node stays there.
void moveTo(Node& node, const Point& to)
{
    const Point by = to - node.at;
    for (Point* handle : {&node.in, &node.out})
        *handle = *handle == node.at ? to : *handle + by;
    node.at = to;
}

} // namespace

void alignAroundSelected(NodeSubpath& subpath)
{
    for (std::size_t i = 0; i < subpath.nodes.size(); ++i) {
        if (subpath.nodes[i].type == NodeType::Corner || subpath.isEnd(i))
            continue;
        const bool near = subpath.nodes[i].selected || subpath.nodes[*subpath.next(i)].selected
                          || subpath.nodes[*subpath.previous(i)].selected;
        if (near)
            alignToLine(subpath, i);
    }
}

bool placeSelected(NodePath& path, const std::function<Point(const Point& at)>& place)
{
    for (const NodeSubpath& subpath : path)
        for (const Node& node : subpath.nodes)
            if (node.selected && !isFinite(place(node.at)))
                return false;
    for (NodeSubpath& subpath : path) {
        for (Node& node : subpath.nodes)
            if (node.selected)
                moveTo(node, place(node.at));
        if (std::ranges::any_of(subpath.nodes, &Node::selected))
            alignAroundSelected(subpath);
    }
    return true;
}

} // namespace app

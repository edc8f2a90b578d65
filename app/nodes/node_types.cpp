// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_types.h"

#include "app/nodes/node_segments.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double inLine = 1e-3; // the sine of the largest angle

double vectorLength(const Point& p) { return std::hypot(p.x, p.y); }

bool opposite(const Point& a, const Point& b)
{
    const double la = vectorLength(a), lb = vectorLength(b);
    if (!(la > 0) || !(lb > 0))
        return false;
    const Point ua = a / la, ub = b / lb;
    return ua.x * ub.x + ua.y * ub.y < 0 && std::abs(cross(ua, ub)) <= inLine;
}

/// A straight segment's way from the node to its other end; a curve's handle.
struct Sides {
    Point in, out;
    bool curvedIn, curvedOut;
};
Sides sidesOf(const NodeSubpath& subpath, std::size_t i)
{
    const Node& node = subpath.nodes[i];
    const bool curvedIn = subpath.curvedInto(i);
    const Point before = subpath.nodes[*subpath.previous(i)].at;
    const Point after = subpath.nodes[*subpath.next(i)].at;
    return {(curvedIn ? node.in : before) - node.at, (node.curved ? node.out : after) - node.at,
            curvedIn, node.curved};
}

/// The direction of the path at a node, from both sides.
Point directionOf(const NodeSubpath& subpath, std::size_t i)
{
    const Sides sides = sidesOf(subpath, i);
    const Point at = subpath.nodes[i].at;
    const auto unit = [&](const Point& handle, std::size_t other) {
        return withLength(handle != Point(0) ? handle : subpath.nodes[other].at - at, 1);
    };
    const Point in = unit(sides.in, *subpath.previous(i)), out = unit(sides.out, *subpath.next(i));
    const Point along = withLength(out - in, 1);
    return along != Point(0) ? along : Point(-out.y, out.x); // it turns back: across
}

/// Curves both segments of each selected node between two lines. Done before any node is made
/// smooth, so that the nodes of a polyline are all treated alike.
void curveBesideCorners(NodeSubpath& subpath)
{
    std::vector<std::size_t> between;
    for (std::size_t i = 0; i < subpath.nodes.size(); ++i)
        if (const bool line = !subpath.nodes[i].curved && !subpath.curvedInto(i);
            subpath.nodes[i].selected && !subpath.isEnd(i) && line)
            between.push_back(i);
    for (const std::size_t i : between)
        for (const std::size_t segment : {*subpath.previous(i), i})
            if (!subpath.nodes[segment].curved)
                curveSegment(subpath, segment);
}

void makeSmooth(NodeSubpath& subpath, std::size_t i)
{
    const Sides was = sidesOf(subpath, i);
    Node& node = subpath.nodes[i];
    const auto third = [&](const Point& handle, std::size_t other) {
        const double own = vectorLength(handle);
        return own > 0 ? own : vectorLength(subpath.nodes[other].at - node.at) / 3;
    };
    const Point along = directionOf(subpath, i);
    if (was.curvedIn != was.curvedOut) {
        Point& handle = was.curvedIn ? node.in : node.out;
        if (handle == node.at)
            handle += along
                      * (was.curvedIn ? -third(Point(0), *subpath.previous(i))
                                      : third(Point(0), *subpath.next(i)));
        return alignToLine(subpath, i);
    }
    const Sides sides = sidesOf(subpath, i);
    if (opposite(sides.in, sides.out))
        return;
    node.in = node.at - along * third(sides.in, *subpath.previous(i));
    node.out = node.at + along * third(sides.out, *subpath.next(i));
}

void makeSymmetric(NodeSubpath& subpath, std::size_t i)
{
    for (const std::size_t segment : {*subpath.previous(i), i})
        if (!subpath.nodes[segment].curved)
            curveSegment(subpath, segment);
    makeSmooth(subpath, i);
    Node& node = subpath.nodes[i];
    const Point in = node.in - node.at, out = node.out - node.at;
    const double mean = (vectorLength(in) + vectorLength(out)) / 2;
    node.out = node.at + withLength(vectorLength(out) > 0 ? out : -in, mean);
    node.in = node.at - (node.out - node.at);
}

} // namespace

Point withLength(const Point& vector, double wanted)
{
    const double is = vectorLength(vector);
    return is > 0 && std::isfinite(is) ? vector / is * wanted : Point(0);
}

NodeType typeOf(const NodeSubpath& subpath, std::size_t node)
{
    if (subpath.isEnd(node))
        return NodeType::Corner;
    const Sides sides = sidesOf(subpath, node);
    if ((!sides.curvedIn && !sides.curvedOut) || !opposite(sides.in, sides.out))
        return NodeType::Corner;
    const double in = vectorLength(sides.in), out = vectorLength(sides.out);
    const bool alike = std::abs(in - out) <= inLine * std::max(in, out);
    return sides.curvedIn && sides.curvedOut && alike ? NodeType::Symmetric : NodeType::Smooth;
}

bool setTypes(NodePath& path, NodeType type)
{
    bool any = false;
    for (NodeSubpath& subpath : path) {
        if (type == NodeType::Smooth)
            curveBesideCorners(subpath);
        for (std::size_t i = 0; i < subpath.nodes.size(); ++i) {
            if (!subpath.nodes[i].selected || subpath.isEnd(i))
                continue;
            any = true;
            if (type == NodeType::Smooth)
                makeSmooth(subpath, i);
            else if (type == NodeType::Symmetric)
                makeSymmetric(subpath, i);
            subpath.nodes[i].type = type;
            weakenType(subpath, *subpath.previous(i));
            weakenType(subpath, *subpath.next(i));
        }
    }
    return any;
}

void alignToLine(NodeSubpath& subpath, std::size_t i)
{
    if (subpath.isEnd(i))
        return;
    const Sides sides = sidesOf(subpath, i);
    Node& node = subpath.nodes[i];
    if (sides.curvedIn == sides.curvedOut)
        return;
    const Point line = sides.curvedIn ? sides.out : sides.in;
    const Point handle = sides.curvedIn ? sides.in : sides.out;
    const Point moved = withLength(-line, vectorLength(handle));
    if (moved != Point(0) && !opposite(line, handle))
        (sides.curvedIn ? node.in : node.out) = node.at + moved;
}

void weakenType(NodeSubpath& subpath, std::size_t node)
{
    Node& weakened = subpath.nodes[node];
    weakened.type = std::min(weakened.type, typeOf(subpath, node));
}

} // namespace app

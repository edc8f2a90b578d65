// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/node_numbers.h"

#include "app/base/keys_in_use.h"
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/direction.h"
#include "app/nodes/node_moves.h"
#include "app/nodes/node_types.h"
#include "app/view/ruler.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

using OptionalNumber = std::optional<double>;

template <int axis>
OptionalNumber nodePlace(const NodeSubpath& subpath, std::size_t node, const Point& origin)
{
    return subpath.nodes[node].at[axis] - origin[axis];
}

template <int axis>
bool placeAt(NodePath& path, double value, const Point& origin)
{
    return placeSelected(path, [&](Point at) {
        at[axis] = origin[axis] + value;
        return at;
    });
}

/// From the node to its handle.
std::optional<Point> arm(const NodeSubpath& subpath, std::size_t node, HandleSide side)
{
    const auto handle = handleOf(subpath, node, side);
    return handle ? std::optional(*handle - subpath.nodes[node].at) : std::nullopt;
}

template <HandleSide side>
OptionalNumber handleLength(const NodeSubpath& subpath, std::size_t node, const Point&)
{
    const auto vector = arm(subpath, node, side);
    return vector ? OptionalNumber(std::hypot(vector->x, vector->y)) : std::nullopt;
}

template <HandleSide side>
OptionalNumber handleAngle(const NodeSubpath& subpath, std::size_t node, const Point&)
{
    const auto vector = arm(subpath, node, side);
    return vector ? OptionalNumber(degreesOf(*vector)) : std::nullopt;
}

/// `change` makes a new arm of the old one.
template <HandleSide side, class Change>
bool changeArms(NodePath& path, const Change& change)
{
    bool any = false;
    for (NodeSubpath& subpath : path)
        for (std::size_t i = 0; i < subpath.nodes.size(); ++i)
            if (const auto old = arm(subpath, i, side); old && subpath.nodes[i].selected)
                any |= moveHandle(subpath, i, side, subpath.nodes[i].at + change(*old));
    return any;
}

template <HandleSide side>
bool lengthen(NodePath& path, double value, const Point&)
{
    return value > 0
           && changeArms<side>(path, [&](const Point& old) { return withLength(old, value); });
}

template <HandleSide side>
bool turnHandle(NodePath& path, double value, const Point&)
{
    return changeArms<side>(
        path, [&](const Point& old) { return directionOf(value) * std::hypot(old.x, old.y); });
}

bool differ(double a, double b)
{
    return std::abs(a - b) > 1e-9 * std::max({1.0, std::abs(a), std::abs(b)}); // of rounding
}

} // namespace

std::span<const NodeNumber> nodeNumbers()
{
    using enum HandleSide;
    static const QString none = Text::tr(
        "There is no handle on this side. Turn the segment into a curve ({curve-segments}).");
    static const std::array all{
        NodeNumber{"node-x",
                   Text::tr("X"),
                   Text::tr("Node X"),
                   Quantity::Coordinate,
                   {},
                   nodePlace<0>,
                   placeAt<0>},
        NodeNumber{"node-y",
                   Text::tr("Y"),
                   Text::tr("Node Y"),
                   Quantity::Coordinate,
                   {},
                   nodePlace<1>,
                   placeAt<1>},
        NodeNumber{"in-length", Text::tr("L"), Text::tr("Length of handle In"), Quantity::Length,
                   none, handleLength<In>, lengthen<In>},
        NodeNumber{"in-angle", Text::tr("∠"), Text::tr("Angle of handle In"), Quantity::Angle, none,
                   handleAngle<In>, turnHandle<In>},
        NodeNumber{"out-length", Text::tr("L"), Text::tr("Length of handle Out"), Quantity::Length,
                   none, handleLength<Out>, lengthen<Out>},
        NodeNumber{"out-angle", Text::tr("∠"), Text::tr("Angle of handle Out"), Quantity::Angle,
                   none, handleAngle<Out>, turnHandle<Out>},
    };
    return all;
}

std::optional<NodeValue> nodeValue(const Session& session, const NodeNumber& number)
{
    const Point origin = originOf(session.now().page(), session.display().unit);
    std::optional<NodeValue> found;
    for (const NodeSubpath& subpath : session.nodes.path())
        for (std::size_t i = 0; i < subpath.nodes.size(); ++i) {
            const OptionalNumber value =
                subpath.nodes[i].selected ? number.value(subpath, i, origin) : std::nullopt;
            if (value && found && differ(*value, found->first))
                return NodeValue{found->first, true};
            if (value && !found)
                found = NodeValue{*value};
        }
    return found;
}

bool setNodeNumber(Session& session, const NodeNumber& number, double value, Merging merging)
{
    NodePath path = session.nodes.path();
    const Point origin = originOf(session.now().page(), session.display().unit);
    if (number.set(path, value, origin))
        return session.nodes.apply(std::move(path), Text::tr("Set %1").arg(number.name.toLower()),
                                   merging);
    emit session.refused(
        number.quantity == Quantity::Length
            ? withKeys(Text::tr("A handle must be longer than 0. To remove it, turn the segment "
                                "into a line ({straighten-segments})."))
            : Text::tr("%1 cannot be set to this number.").arg(number.name));
    return false;
}

std::optional<NodeType> typeOfNodes(const Session& session)
{
    const NodeSummary& nodes = session.nodes.summary();
    const auto type = std::ranges::find(nodes.types, nodes.selected);
    return nodes.selected > 0 && type != nodes.types.end()
               ? std::optional(NodeType(type - nodes.types.begin()))
               : std::nullopt;
}

QString nodesText(const Session& session)
{
    const NodeSummary& nodes = session.nodes.summary();
    const QString count = countText(nodes.nodes);
    if (!nodes.only)
        return Text::tr("%1 of %2 nodes").arg(countText(nodes.selected), count);
    std::size_t number = nodes.only->node + 1;
    for (std::size_t s = 0; s < nodes.only->subpath; ++s)
        number += session.nodes.path()[s].nodes.size();
    return Text::tr("node %1 of %2").arg(countText(number), count);
}

} // namespace app

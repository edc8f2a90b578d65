// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_path.h"

#include <functional>

namespace app {

/// A node of a path: which subpath, and which of its nodes.
struct NodeAddress {
    std::size_t subpath = 0, node = 0;
    friend auto operator<=>(const NodeAddress&, const NodeAddress&) = default;
};

/// The handle before or after a node.
enum class HandleSide : std::uint8_t { In, Out };

/// The handle's position; empty: the segment is straight, or the handle lies on its node.
std::optional<Point> handleOf(const NodeSubpath& subpath, std::size_t node, HandleSide side);

/// Moves the selected nodes with their handles. False, without a change: `by` is not finite.
bool moveSelected(NodePath& path, const Point& by);
/// Moves the selected nodes so that this one, which is one of them, lies exactly at `to`.
bool moveSelectedTo(NodePath& path, const NodeAddress& node, const Point& to);

/// Moves a handle of a curve; the other handle of a smooth or symmetric node follows. Beside a
/// straight segment, the handle of a smooth node stays in line with it. False: refused.
bool moveHandle(NodeSubpath& subpath, std::size_t node, HandleSide side, const Point& to);

/// Moves the point at t of a curve by a vector: the handles of the curve follow, its ends stay, and
/// smooth nodes stay smooth. False: the segment is straight, or refused.
bool bendSegment(NodeSubpath& subpath, std::size_t segment, double t, const Point& by);

/// The next node, or the one before it, in the order of the path; after the last one the first.
/// Without nodes there is none.
std::optional<NodeAddress> neighbour(const NodePath& path, const std::optional<NodeAddress>& of,
                                     bool forwards);

/// Moves each selected node, with its handles, exactly to where `place` says. False, without a
/// change: a place is not finite.
bool placeSelected(NodePath& path, const std::function<Point(const Point& at)>& place);

/// After selected nodes have moved: keeps the handles of smooth nodes near them in line with their
/// straight segments.
void alignAroundSelected(NodeSubpath& subpath);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_moves.h"

// Finds nodes, handles and segments by position. Distances are in user units.

namespace app {

/// The nearest node within `radius`; of nodes on one spot a selected one, else the last.
std::optional<NodeAddress> nodeAt(const NodePath& path, const Point& point, double radius);

/// The number of nodes that lie exactly there.
std::size_t nodesOn(const NodePath& path, const Point& spot);

/// The nodes in a rectangle, its borders included, become selected.
void selectWithin(NodePath& path, const clipping::Window& rectangle);

/// A handle that is shown: of a selected node, or of its neighbour beside their common segment.
struct ShownHandle {
    NodeAddress node;
    HandleSide side;
    Point at;
    bool neighbours = false;
};
/// None if more nodes are selected: they would cover the drawing.
constexpr std::size_t mostWithHandles = 100;
std::vector<ShownHandle> shownHandles(const NodePath& path);

/// A point of a segment.
struct SegmentPoint {
    NodeAddress segment; ///< by the node where it begins
    double t;
    Point at;
};
/// The nearest point of the path within `radius`.
std::optional<SegmentPoint> segmentAt(const NodePath& path, const Point& point, double radius);

} // namespace app

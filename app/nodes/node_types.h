// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_path.h"

// Corner, smooth and symmetric nodes. Beside a straight segment, a smooth node has one handle, in
// line with that segment.

namespace app {

/// The most special type that the handles allow: in line to a thousandth, which files with few
/// decimals reach.
NodeType typeOf(const NodeSubpath& subpath, std::size_t node);

/// Gives the selected nodes this type and moves their handles as it demands. A straight segment
/// that has no handle becomes a curve where the type needs one. Ends of open subpaths stay corners.
/// Whether any node can have the type.
bool setTypes(NodePath& path, NodeType type);

/// After the node has moved: puts the handle of a smooth node in line with its straight segment
/// again.
void alignToLine(NodeSubpath& subpath, std::size_t node);
/// After segments have changed: a type that the handles no longer have is given up.
void weakenType(NodeSubpath& subpath, std::size_t node);

/// The vector in the direction of another one with this length; zero if that is zero.
Point withLength(const Point& vector, double length);

} // namespace app

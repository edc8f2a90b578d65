// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_path.h"

// Changes of whole subpaths, none of which changes the shape apart from new straight segments.

namespace app {

void reverse(NodeSubpath& subpath); ///< a closed one keeps its first node
/// By a straight segment, or by one node if both ends lie on one spot. False: it is closed already,
/// or a single node.
bool close(NodeSubpath& subpath);
/// At a node, which becomes two on one spot: both ends. False: it is open already.
bool open(NodeSubpath& subpath, std::size_t at);

/// Splits at every selected node: a closed subpath opens there, an open one becomes two. Of the two
/// nodes on one spot the second one stays selected. Whether anything was split.
bool splitAtSelected(NodePath& path);

} // namespace app

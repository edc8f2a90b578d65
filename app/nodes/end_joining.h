// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_path.h"

namespace app {

/// Joins ends of open subpaths. If at least two ends are selected, only those count, otherwise all
/// of them. Every two ends that are at most `tolerance` apart, the nearest first, become one node
/// in the middle. If there are none and exactly two ends are selected, a straight segment joins
/// them.
///
/// The joined subpath takes the place and the direction of the earlier one. `owners`, one for each
/// subpath, loses the later one's. Returns the number of joints.
std::size_t joinEnds(NodePath& path, std::vector<std::size_t>& owners, double tolerance);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_path.h"

#include <cstdint>

namespace app {

/// Joins ends of open subpaths. If at least two ends are selected, only those count, otherwise all
/// of them. Every two ends that are at most `tolerance` apart, the nearest first, become one node
/// in the middle. If there are none and exactly two ends are selected, a straight segment joins
/// them. `pens` has a number for each subpath, for example one for each layer and style: only ends
/// with the same number are joined.
///
/// The joined subpath takes the place and the direction of the earliest one; if it is closed, it
/// begins where that one did. `owners`, one for each subpath, loses those of the others. Returns
/// the number of joints. O(nodes + ends · log ends), unless many ends are equally far apart.
std::size_t joinEnds(NodePath& path, std::vector<std::size_t>& owners, double tolerance,
                     std::span<const std::uint32_t> pens);

} // namespace app

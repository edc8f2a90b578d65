// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_moves.h"

#include <array>

namespace app {

/// What decides which changes of nodes are possible; collected in one pass.
struct NodeSummary {
    std::size_t nodes = 0, selected = 0;
    std::size_t selectedEnds = 0;       ///< of open subpaths
    std::size_t open = 0, closed = 0;   ///< subpaths, without single points
    std::array<std::size_t, 3> types{}; ///< of the selected nodes, by NodeType
    /// Segments that a change would concern (node_segments.h).
    std::size_t straight = 0, curved = 0;
    std::optional<NodeAddress> only{}; ///< the selected node, if there is only one
};
NodeSummary summaryOf(const NodePath& path);

} // namespace app

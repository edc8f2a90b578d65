// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_summary.h"

#include "app/nodes/node_segments.h"

namespace app {

NodeSummary summaryOf(const NodePath& path)
{
    NodeSummary summary;
    for (std::size_t s = 0; s < path.size(); ++s) {
        const NodeSubpath& subpath = path[s];
        summary.nodes += subpath.nodes.size();
        if (subpath.segmentCount() > 0)
            ++(subpath.closed ? summary.closed : summary.open);
        for (std::size_t i = 0; i < subpath.nodes.size(); ++i)
            if (subpath.nodes[i].selected) {
                ++summary.selected;
                summary.selectedEnds += subpath.isEnd(i);
                ++summary.types[std::size_t(subpath.nodes[i].type)];
                summary.only = NodeAddress{s, i};
            }
    }
    if (summary.selected != 1)
        summary.only.reset();
    for (const NodeAddress& segment : chosenSegments(path))
        ++(path[segment.subpath].nodes[segment.node].curved ? summary.curved : summary.straight);
    return summary;
}

} // namespace app

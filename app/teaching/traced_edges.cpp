// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/traced_edges.h"

namespace app {

std::vector<clipping::Segment> edgesOf(const TracedLine& tracedLine)
{
    const auto& [min, max] = tracedLine.window;
    std::vector<glm::dvec2> corners = tracedLine.corners;
    if (corners.empty())
        corners = {min, {max.x, min.y}, max, {min.x, max.y}};
    std::vector<clipping::Segment> edges;
    for (std::size_t i = 0; i < corners.size(); ++i)
        edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
    return edges;
}

} // namespace app

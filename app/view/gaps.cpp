// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/gaps.h"

#include <glm/geometric.hpp>

#include <utility>

namespace app {

using clipping::Clipped;
using clipping::Edge;
using clipping::Segment;

void appendGaps(const Segment& line, std::uint32_t source, std::span<const Clipped> kept,
                std::vector<Clipped>& gaps)
{
    Segment gap = line; // its b is set when the gap ends
    Edge from = Edge::NoEdge;
    bool touched = false;
    for (const Clipped& piece : kept) {
        Segment part = piece.segment;
        Edge enter = clipping::cutEdgeOfA(piece.cut), leave = clipping::cutEdgeOfB(piece.cut);
        if (part.a == part.b && line.a != line.b)
            continue;
        if (glm::dot(part.b - part.a, line.b - line.a) < 0) {
            std::swap(part.a, part.b);
            std::swap(enter, leave);
        }
        if (part.a != gap.a)
            gaps.push_back({{gap.a, part.a}, source, clipping::cutAt(from, enter)});
        gap.a = part.b;
        from = leave;
        touched = true;
    }
    if (!touched)
        gaps.push_back({line, source, 0});
    else if (gap.a != line.b)
        gaps.push_back({{gap.a, line.b}, source, clipping::cutAt(from, Edge::NoEdge)});
}

} // namespace app

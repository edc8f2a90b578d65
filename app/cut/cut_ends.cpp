// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/cut_ends.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using clipping::Edge;

std::optional<Point> edgeDirection(Edge edge, const ClipRegion& region,
                                   const clipping::Segment& line, const Point& cut)
{
    if (edge == Edge::NoEdge)
        return std::nullopt;
    if (edge != borderEdge)
        return edge == Edge::Left || edge == Edge::Right ? Point(0, 1) : Point(1, 0);
    const auto border = borderAt(region, line, cut);
    return border ? std::optional(border->b - border->a) : std::nullopt;
}

} // namespace

std::optional<clipping::Segment> borderAt(const ClipRegion& region, const clipping::Segment& line,
                                          const Point& cut)
{
    if (!region.prepared)
        return std::nullopt;
    for (const auto& piece : clipping::clip(line, region.prepared->prepared()))
        for (const auto& [end, edge] :
             {std::pair(piece.segment.a, piece.edgeOfA), std::pair(piece.segment.b, piece.edgeOfB)})
            if (end == cut && edge != 0)
                return region.prepared->prepared().edge(edge).segment;
    return std::nullopt;
}

double gapAtEdge(const Point& edge, const Point& line, double width)
{
    const double across = std::abs(cross(edge, line)), beside = std::abs(glm::dot(edge, line));
    return across > 0 ? width / 2 * (beside / across) : 0;
}

double gapAtEnds(const clipping::Segment& line, const KeptPart& part, double width,
                 const ClipRegion& region)
{
    const Point ahead = line.b - line.a;
    double gap = 0;
    for (const auto& [end, edge] :
         {std::pair(part.segment.a, part.edgeA), std::pair(part.segment.b, part.edgeB)})
        if (const auto along = edgeDirection(edge, region, line, end))
            gap = std::max(gap, gapAtEdge(*along, ahead, width));
    return gap;
}

} // namespace app

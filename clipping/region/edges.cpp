// SPDX-License-Identifier: MIT
#include "clipping/region/edges.h"

#include "clipping/ieee_numbers.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace clipping {
namespace {

/// Appends the edges of an area whose first point has the index `first` among all points.
void append(std::vector<AreaEdge>& edges, const Area& area, std::uint32_t step, std::size_t first)
{
    const auto ring = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto &p = area.points[i], &q = area.points[i + 1 == end ? begin : i + 1];
            if (p != q)
                edges.push_back({{p, q}, step, static_cast<std::uint32_t>(first + i + 1)});
        }
    };
    if (area.ringEnds.empty())
        ring(0, area.points.size());
    std::size_t begin = 0;
    for (const std::size_t end : area.ringEnds) {
        assert(begin <= end && end <= area.points.size());
        ring(begin, end);
        begin = end;
    }
}

} // namespace

bool isFinite(const Area& area)
{
    return std::ranges::all_of(
        area.points, [](const auto& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

Area areaOf(const Window& w)
{
    const bool hasArea = w.min.x < w.max.x && w.min.y < w.max.y;
    return hasArea ? Area{{w.min, {w.max.x, w.min.y}, w.max, {w.min.x, w.max.y}}} : Area{};
}

std::vector<AreaEdge> edgesOf(const Region& region)
{
    std::vector<AreaEdge> edges;
    std::size_t first = 0, all = 0;
    for (const auto& step : region.steps)
        all += step.area.points.size();
    edges.reserve(all);
    for (std::size_t i = 0; i < region.steps.size(); ++i) {
        const Area& area = region.steps[i].area;
        if (isFinite(area))
            append(edges, area, static_cast<std::uint32_t>(i), first);
        first += area.points.size();
    }
    assert(first < 0xffffffff);
    return edges;
}

Window boxOf(std::span<const AreaEdge> edges)
{
    Window box{edges.front().segment.a, edges.front().segment.a};
    for (const AreaEdge& edge : edges) {
        box.min = glm::min(box.min, edge.segment.a);
        box.max = glm::max(box.max, edge.segment.a);
        box.min = glm::min(box.min, edge.segment.b);
        box.max = glm::max(box.max, edge.segment.b);
    }
    return box;
}

} // namespace clipping

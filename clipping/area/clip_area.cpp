// SPDX-License-Identifier: MIT
#include "clipping/area/clip_area.h"

#include "clipping/area/boundary_sweep.h"
#include "clipping/ieee_numbers.h"

#include <glm/common.hpp>

#include <numeric>
#include <optional>

namespace clipping {
namespace {

using Data = PreparedRegion::Data;

/// The edges of the window that may meet the area's bounding box: their indices, ascending.
std::vector<std::uint32_t> edgesNear(const Data& window, const Data& area)
{
    std::vector<std::uint32_t> near;
    if (window.edges.empty())
        return near;
    if (area.keepsNone) {
        near.resize(window.edges.size());
        std::iota(near.begin(), near.end(), 0);
        return near;
    }
    window.grid.trace(area.grid.box(), [&](std::size_t first, std::size_t last) {
        const auto listed = window.grid.edgesIn(first, last);
        near.insert(near.end(), listed.begin(), listed.end());
    });
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
}

bool areApart(const Window& p, const Window& q)
{
    return p.max.x < q.min.x || p.min.x > q.max.x || p.max.y < q.min.y || p.min.y > q.max.y;
}

/// Whether a segment has no point in a box.
bool misses(const Segment& s, const Window& box)
{
    if (areApart({glm::min(s.a, s.b), glm::max(s.a, s.b)}, box))
        return true;
    const int side = leftOf(s.a, s.b, box.min).sign;
    return side != 0 && leftOf(s.a, s.b, box.max).sign == side
           && leftOf(s.a, s.b, {box.min.x, box.max.y}).sign == side
           && leftOf(s.a, s.b, {box.max.x, box.min.y}).sign == side;
}

/// What the window leaves of all within a box, if none of its edges meets the box.
std::optional<AreaPart> lookAt(const Window& box, const PreparedRegion& region)
{
    const Data& window = region.data();
    const auto known = [](bool isKept) { return isKept ? AreaPart::Whole : AreaPart::None; };
    if (window.edges.empty() || areApart(box, window.grid.box()))
        return known(window.keepsNone);
    bool isFree = true;
    window.grid.trace(box, [&](std::size_t first, std::size_t last) {
        isFree = isFree && std::ranges::all_of(window.grid.edgesIn(first, last), [&](auto i) {
                     return misses(window.edges[i].segment, box);
                 });
    });
    if (!isFree)
        return std::nullopt;
    return known(!clip({box.min, box.min}, region).empty());
}

ClippedArea clipped(const Data& area, const Data& window)
{
    BoundarySweep sweep(area, window);
    for (const AreaEdge& edge : area.edges)
        sweep.walkAreaEdge(edge);
    for (const std::uint32_t i : edgesNear(window, area))
        sweep.walkWindowEdge(window.edges[i]);
    if (sweep.isEmpty())
        return {};
    return sweep.isWhole() ? ClippedArea{AreaPart::Whole} : ringsOf(sweep.pieces());
}

} // namespace

ClippedArea clipArea(const PreparedRegion& area, const PreparedRegion& window)
{
    const Data &a = area.data(), &w = window.data();
    if (!a.isFinite || !w.isFinite || (a.keepsNone && w.keepsNone))
        return {AreaPart::Refused};
    if (!a.keepsNone) {
        if (a.edges.empty())
            return {};
        if (const auto part = lookAt(a.grid.box(), window))
            return {*part};
    }
    return clipped(a, w);
}

ClippedArea clipArea(const Area& area, const PreparedRegion& window)
{
    const Data& w = window.data();
    if (!isFinite(area) || !w.isFinite)
        return {AreaPart::Refused};
    if (area.points.empty())
        return {};
    Window box{area.points[0], area.points[0]};
    for (const glm::dvec2& p : area.points)
        box = {glm::min(box.min, p), glm::max(box.max, p)};
    if (const auto part = lookAt(box, window))
        return {*part};
    return clipArea(PreparedRegion({{{area}}}), window);
}

} // namespace clipping

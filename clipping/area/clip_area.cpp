// SPDX-License-Identifier: MIT
#include "clipping/area/clip_area.h"

#include "clipping/area/boundary_sweep.h"
#include "clipping/ieee_numbers.h"

#include <numeric>

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

} // namespace

ClippedArea clipArea(const PreparedRegion& area, const PreparedRegion& window)
{
    const Data &a = area.data(), &w = window.data();
    if (!a.isFinite || !w.isFinite || (a.keepsNone && w.keepsNone))
        return {AreaPart::Refused};
    if (a.edges.empty() && !a.keepsNone)
        return {};
    BoundarySweep sweep(a, w);
    for (const AreaEdge& edge : a.edges)
        sweep.walkAreaEdge(edge);
    for (const std::uint32_t i : edgesNear(w, a))
        sweep.walkWindowEdge(w.edges[i]);
    if (sweep.isEmpty())
        return {};
    return sweep.isWhole() ? ClippedArea{AreaPart::Whole} : ringsOf(sweep.pieces());
}

ClippedArea clipArea(const Area& area, const PreparedRegion& window)
{
    return clipArea(PreparedRegion({{{area}}}), window);
}

} // namespace clipping

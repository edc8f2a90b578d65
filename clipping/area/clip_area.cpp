// SPDX-License-Identifier: MIT
#include "clipping/area/clip_area.h"

#include "clipping/area/boundary_sweep.h"
#include "clipping/ieee_numbers.h"
#include "clipping/region/box_part.h"

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

/// What the window leaves of all within a box, if none of its edges meets the box.
std::optional<AreaPart> lookAt(const Window& box, const PreparedRegion& window)
{
    const BoxPart part = partOf(box, window);
    if (part == BoxPart::Undecided)
        return std::nullopt;
    return part == BoxPart::Whole ? AreaPart::Whole : AreaPart::None;
}

ClippedArea clipped(const Data& area, const Data& window, const std::stop_token& stop)
{
    BoundarySweep sweep(area, window);
    for (const AreaEdge& edge : area.edges) {
        if (stop.stop_requested())
            return {AreaPart::Stopped};
        sweep.walkAreaEdge(edge);
    }
    for (const std::uint32_t i : edgesNear(window, area)) {
        if (stop.stop_requested())
            return {AreaPart::Stopped};
        sweep.walkWindowEdge(window.edges[i]);
    }
    if (sweep.isEmpty())
        return {};
    return sweep.isWhole() ? ClippedArea{AreaPart::Whole} : ringsOf(sweep.pieces(), stop);
}

} // namespace

ClippedArea clipArea(const PreparedRegion& area, const PreparedRegion& window,
                     const std::stop_token& stop)
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
    return clipped(a, w, stop);
}

ClippedArea clipArea(const Area& area, const PreparedRegion& window, const std::stop_token& stop)
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
    return clipArea(PreparedRegion({{{area}}}), window, stop);
}

} // namespace clipping

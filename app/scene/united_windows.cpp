// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/united_windows.h"

#include "app/scene/area_windows.h"
#include "clipping/area/clip_area.h"

#include <glm/common.hpp>

namespace app {
namespace {

// Larger than all of them, so that it is never kept whole.
clipping::Window around(const ClipRegion& region)
{
    clipping::Window box = region.steps.front().box;
    for (const ClipRegion::Step& step : region.steps)
        box = {glm::min(box.min, step.box.min), glm::max(box.max, step.box.max)};
    const Point more = (box.max - box.min) * 0.5 + 1.0;
    return {box.min - more, box.max + more};
}

} // namespace

PathShape united(std::span<const ClipWindow> windows, const Page& page)
{
    ClipWindows all;
    for (const ClipWindow& window : windows)
        all.list.push_back({.shape = window.shape});
    const ClipRegion region = regionOf(all, page);
    const auto area = clipping::clipArea(clipping::areaOf(around(region)), *areaWindows(region));
    std::vector<Subpath> rings;
    std::size_t first = 0;
    for (const std::uint32_t end : area.ringEnds) {
        Subpath& ring = rings.emplace_back(Subpath{area.points[first], {}, true});
        while (++first < end)
            ring.segments.push_back({area.points[first]});
    }
    return {Path(rings), FillRule::NonZero};
}

} // namespace app

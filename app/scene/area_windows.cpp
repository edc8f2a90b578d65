// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/area_windows.h"

#include "app/base/finite.h"
#include "clipping/algorithm.h"
#include "clipping/area/clip_area.h"

#include <glm/common.hpp>

#include <algorithm>

namespace app {

static_assert(int(clipping::FillRule::EvenOdd) == int(FillRule::EvenOdd));
static_assert(int(clipping::AreaOperation::Intersect) == int(WindowOperation::Intersect));
static_assert(int(clipping::Keep::Outside) == int(Keep::Outside));

bool isProper(const clipping::Window& box)
{
    return isFinite(box) && box.min.x <= box.max.x && box.min.y <= box.max.y;
}

clipping::Area areaOf(const ClipRegion::Step& step)
{
    if (step.rings.empty())
        return isProper(step.box) ? clipping::areaOf(step.box) : clipping::Area();
    clipping::Area area;
    area.rule = clipping::FillRule(step.rule);
    for (const auto& ring : step.rings) {
        area.points.insert(area.points.end(), ring.begin(), ring.end());
        area.ringEnds.push_back(std::uint32_t(area.points.size()));
    }
    return area;
}

std::shared_ptr<const LaterRegion> laterRegion(const ClipRegion& region, Keep keep)
{
    if (region.steps.size() == 1 && keep == Keep::Inside) {
        const ClipRegion::Step& only = region.steps.front();
        if (only.area && only.operation == WindowOperation::Add)
            return only.area;
    }
    clipping::Region windows{{}, clipping::Keep(keep)};
    for (const ClipRegion::Step& step : region.steps)
        windows.steps.push_back({areaOf(step), clipping::AreaOperation(step.operation)});
    return std::make_shared<const LaterRegion>(std::move(windows));
}

std::shared_ptr<const clipping::PreparedRegion> areaWindows(const ClipRegion& region)
{
    const auto windows = region.prepared ? region.prepared : laterRegion(region, region.keep);
    return {windows, &windows->prepared()};
}

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

// Whether the library takes it for a convex polygon: then each corner is inside.
static bool containsItsCorner(const clipping::ConvexPolygon& polygon)
{
    const Point& corner = polygon.corners.front();
    return clipping::exactAlgorithm().polygon->clip({corner, corner}, polygon).has_value();
}

clipping::ConvexPolygon convexPolygonOf(const std::vector<std::vector<Point>>& rings)
{
    if (rings.size() != 1 || rings.front().size() < 3)
        return {};
    clipping::ConvexPolygon polygon{rings.front()};
    const bool anticlockwise = containsItsCorner(polygon);
    if (anticlockwise) {
        clipping::ConvexPolygon reversed{{polygon.corners.rbegin(), polygon.corners.rend()}};
        return containsItsCorner(reversed) ? clipping::ConvexPolygon() : polygon; // both: no area
    }
    std::ranges::reverse(polygon.corners);
    return containsItsCorner(polygon) ? polygon : clipping::ConvexPolygon();
}

} // namespace app

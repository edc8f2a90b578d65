// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/region.h"

#include "app/document/window_outline.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

static_assert(int(clipping::FillRule::EvenOdd) == int(FillRule::EvenOdd));
static_assert(int(clipping::AreaOperation::Intersect) == int(WindowOperation::Intersect));
static_assert(int(clipping::Keep::Outside) == int(Keep::Outside));

namespace {

bool isFinite(const clipping::Window& box)
{
    return std::isfinite(box.min.x) && std::isfinite(box.min.y) && std::isfinite(box.max.x)
           && std::isfinite(box.max.y);
}

// Whether the box is finite and not inverted, so that it contains at least one point.
bool isProper(const clipping::Window& box)
{
    return isFinite(box) && box.min.x <= box.max.x && box.min.y <= box.max.y;
}

/// How much of a box a set of points contains.
enum class Share : std::uint8_t { None, All, Some };

Share shareIn(const ClipRegion::Step& step, const clipping::Window& box)
{
    const clipping::Window& window = step.box;
    if (!isProper(window) || box.max.x < window.min.x || box.min.x > window.max.x
        || box.max.y < window.min.y || box.min.y > window.max.y)
        return Share::None;
    const bool all = box.min.x >= window.min.x && box.max.x <= window.max.x
                     && box.min.y >= window.min.y && box.max.y <= window.max.y;
    return all && step.rings.empty() ? Share::All : Share::Some;
}

Share opposite(Share share)
{
    return share == Share::None ? Share::All : share == Share::All ? Share::None : Share::Some;
}

Share either(Share a, Share b)
{
    if (a == Share::All || b == Share::All)
        return Share::All;
    return a == Share::None && b == Share::None ? Share::None : Share::Some;
}

Share both(Share a, Share b) { return opposite(either(opposite(a), opposite(b))); }

Share after(WindowOperation operation, Share before, Share window)
{
    if (operation == WindowOperation::Add)
        return either(before, window);
    return both(before, operation == WindowOperation::CutOut ? opposite(window) : window);
}

ClipRegion::Step stepOf(const ClipWindow& window, double tolerance)
{
    if (const auto box = axisAlignedBox(window.shape))
        return {*box, window.operation};
    WindowOutline outline = outlineOf(window.shape, tolerance);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    clipping::Window box{Point(infinite), Point(-infinite)};
    for (const auto& ring : outline.rings)
        for (const Point& corner : ring)
            box = {glm::min(box.min, corner), glm::max(box.max, corner)};
    return {box, window.operation, std::move(outline.rings), outline.rule};
}

// A window without a border contains nothing; then its box is not proper either.
bool isAxisAligned(const ClipRegion::Step& step)
{
    return step.rings.empty() && isProper(step.box);
}

clipping::Area areaOf(const ClipRegion::Step& step)
{
    if (isAxisAligned(step))
        return clipping::areaOf(step.box);
    clipping::Area area;
    area.rule = clipping::FillRule(step.rule);
    for (const auto& ring : step.rings) {
        area.points.insert(area.points.end(), ring.begin(), ring.end());
        area.ringEnds.push_back(std::uint32_t(area.points.size()));
    }
    return area;
}

void prepare(ClipRegion& region)
{
    const auto shaped = [](const ClipRegion::Step& step) { return !step.rings.empty(); };
    if (std::ranges::none_of(region.steps, shaped))
        return;
    clipping::Region all{{}, clipping::Keep(region.keep)};
    for (const ClipRegion::Step& step : region.steps)
        all.steps.push_back({areaOf(step), clipping::AreaOperation(step.operation)});
    region.prepared = std::make_shared<const clipping::PreparedRegion>(all);
}

} // namespace

std::optional<clipping::Window> ClipRegion::single() const
{
    if (prepared || steps.size() != 1 || steps.front().operation == WindowOperation::CutOut)
        return std::nullopt;
    return steps.front().box;
}

ClipRegion regionOf(const ClipWindows& windows, double tolerance)
{
    ClipRegion region{{}, windows.keep};
    for (const ClipWindow& window : windows.list)
        if (window.visible)
            region.steps.push_back(stepOf(window, tolerance));
    prepare(region);
    return region;
}

ClipRegion regionOf(const ClipWindows& windows, const Page& page)
{
    return regionOf(windows, windowMillimetres / page.millimetresPerUnit());
}

ClipRegion withKeep(ClipRegion region, Keep keep)
{
    if (region.keep == keep)
        return region;
    region.keep = keep;
    prepare(region);
    return region;
}

Remains remainsOf(const ClipRegion& region, const clipping::Window& box)
{
    if (region.everything())
        return Remains::Whole;
    if (!isProper(box))
        return Remains::Pieces;
    Share share = region.startsFull() ? Share::All : Share::None;
    for (const ClipRegion::Step& step : region.steps) {
        const Point size = step.box.max - step.box.min;
        const bool flat = region.prepared && !(size.x > 0 && size.y > 0);
        share = after(step.operation, share, flat ? Share::None : shareIn(step, box));
    }
    if (share == Share::Some)
        return Remains::Pieces;
    return (share == Share::All) == (region.keep == Keep::Inside) ? Remains::Whole : Remains::Gone;
}

} // namespace app

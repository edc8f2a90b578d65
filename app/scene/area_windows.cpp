// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/area_windows.h"

#include "app/base/finite.h"

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

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/area_windows.h"

namespace app {

std::shared_ptr<const clipping::PreparedRegion> areaWindows(const ClipRegion& region)
{
    if (region.prepared)
        return region.prepared;
    clipping::Region windows{{}, clipping::Keep(region.keep)};
    for (const ClipRegion::Step& step : region.steps)
        windows.steps.push_back(
            {clipping::areaOf(step.box), clipping::AreaOperation(step.operation)});
    return std::make_shared<const clipping::PreparedRegion>(windows);
}

} // namespace app

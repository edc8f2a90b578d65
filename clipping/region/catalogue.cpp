// SPDX-License-Identifier: MIT
#include "clipping/region/catalogue.h"

#include "clipping/ieee_numbers.h"
#include "clipping/region/winding_number.h"

#include <algorithm>
#include <array>

namespace clipping {

std::span<const RegionAlgorithm> regionAlgorithms()
{
    static constexpr std::array all{
        RegionAlgorithm{"winding-number",
                        "Test every edge against the line, and count the winding number from far "
                        "behind the segment to its end.",
                        0.5, windingClip, windingClipAll},
        RegionAlgorithm{"exact",
                        "Walk along both sides of the line, counting each area's winding number, "
                        "past edges in their exact order.",
                        0.5, clip, clipAll},
    };
    return all;
}

const RegionAlgorithm* findRegionAlgorithm(std::string_view key)
{
    const auto all = regionAlgorithms();
    const auto found = std::ranges::find(all, key, &RegionAlgorithm::key);
    return found == all.end() ? nullptr : &*found;
}

} // namespace clipping

// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/prepared.h"

#include <array>

namespace clipping {

/// Decides segments by the cells of a grid alone, where no edge has to be tested.
class FirstLook {
public:
    enum class Known : std::uint8_t { Gone, Whole, Undecided };
    /// A segment of which a part may be kept.
    struct Seen {
        std::uint32_t index;
        Known known; ///< Whole or Undecided
    };
    static constexpr std::size_t mostAtOnce = 512;

    FirstLook(const PreparedRegion::Data& region, const RegionGrid& grid)
        : grid_(grid), none_(region.keepsNone), hasNoEdge_(region.edges.empty() ? ~0U : 0)
    {
    }
    /// Looks at `mostAtOnce` segments at most. Valid until the next call.
    std::span<const Seen> at(std::span<const Segment> segments);

private:
    Known at(const Segment& s) const;

    const RegionGrid& grid_;
    unsigned none_;      ///< Known, for a segment that is not finite or off the grid
    unsigned hasNoEdge_; ///< 0 or all bits
    std::array<Seen, mostAtOnce> seen_;
};

} // namespace clipping

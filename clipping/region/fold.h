// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/region.h"

#include <bit>

namespace clipping {

/// Folds the answers "is the point in this area?" of all steps into "is it kept?". The last step
/// decides that leaves no choice: an area that contains the point and adds or cuts out, or one that
/// does not and intersects. So the state is one bit for each step, set where the step decides, and
/// the last set bit gives the result.
class RegionFold {
public:
    using Words = std::vector<std::uint64_t>;

    explicit RegionFold(const Region& region)
        : everything_(region.steps.empty()), keepsInside_(region.keep == Keep::Inside),
          startsFull_(!everything_ && region.steps.front().operation != AreaOperation::Add),
          adds_((region.steps.size() + 63) / 64), inNone_(adds_.size())
    {
        for (std::size_t i = 0; i < region.steps.size(); ++i) {
            if (region.steps[i].operation == AreaOperation::Add)
                flip(adds_, i);
            if (region.steps[i].operation == AreaOperation::Intersect)
                flip(inNone_, i);
        }
    }

    /// The state of a point that is in no area. `flip` changes the answer of one step.
    const Words& inNone() const { return inNone_; }
    static void flip(Words& state, std::size_t step)
    {
        state[step / 64] ^= std::uint64_t(1) << step % 64;
    }

    bool keeps(const Words& state) const
    {
        bool in = startsFull_;
        for (std::size_t i = state.size(); i-- > 0;)
            if (state[i] != 0) {
                in = adds_[i] >> (std::bit_width(state[i]) - 1) & 1;
                break;
            }
        return everything_ || in == keepsInside_;
    }

private:
    bool everything_, keepsInside_, startsFull_;
    Words adds_, inNone_;
};

} // namespace clipping

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/progress.h"

#include <cassert>
#include <numeric>

namespace app {

PhasedProgress::PhasedProgress(const Follower& follower, std::vector<double> weights)
    : follower_(follower), start_(clock_.nanoseconds()), weights_(std::move(weights)),
      all_(std::accumulate(weights_.begin(), weights_.end(), 0.0))
{
}

Follower PhasedProgress::next()
{
    assert(next_ < weights_.size());
    const double before =
        std::accumulate(weights_.begin(), weights_.begin() + std::ptrdiff_t(next_), 0.0);
    const double weight = weights_[next_++];
    if (!follower_.progress)
        return follower_;
    return {follower_.stop, [this, before, weight](const Progress& now) {
                follower_.progress(overall(before, weight, now));
            }};
}

/// The current phase reports its own remaining time; the later phases are estimated from the
/// average speed so far.
Progress PhasedProgress::overall(double before, double weight, const Progress& now) const
{
    const double done = before + weight * now.share;
    const double seconds = (clock_.nanoseconds() - start_) * 1e-9;
    const double later = done > 0 ? seconds / done * (all_ - before - weight) : 0;
    return {done / all_, now.secondsLeft + later};
}

TurnProgress::TurnProgress(const Follower& follower, double turns)
    : follower_(follower), start_(clock_.nanoseconds()), turns_(turns)
{
}

void TurnProgress::turnDone(double turns)
{
    done_ += turns;
    const double share = done_ / turns_;
    if (follower_.progress)
        follower_.progress({share, (clock_.nanoseconds() - start_) * (1 / share - 1) * 1e-9});
}

} // namespace app

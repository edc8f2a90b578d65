// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/turn_progress.h"

namespace app {

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

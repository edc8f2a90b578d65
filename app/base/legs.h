// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/clock.h"
#include "app/base/progress.h"

namespace app {

/// A way of several legs, one after another, which a follower sees as one from 0 to 1.
class Legs {
public:
    /// One weight a leg: what it takes, roughly, in any unit.
    Legs(const Follower& follower, std::vector<double> weights);

    /// Who follows the next leg, for as long as the legs live; the one before is over.
    Follower next();

private:
    Progress overall(double before, double weight, const Progress& now) const;

    Follower follower_;
    Clock clock_ = wallClock();
    double start_;
    std::vector<double> weights_;
    double all_;
    std::size_t next_ = 0;
};

} // namespace app

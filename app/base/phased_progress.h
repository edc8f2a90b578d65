// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/clock.h"
#include "app/base/progress.h"

namespace app {

/// Combines the progress of several consecutive phases into one progress from 0 to 1.
class PhasedProgress {
public:
    /// One weight for each phase: its approximate duration, in any unit.
    PhasedProgress(const Follower& follower, std::vector<double> weights);

    /// Starts the next phase and ends the previous one. Returns the follower to pass to the phase;
    /// it is valid as long as this object.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/clock.h"

#include <functional>
#include <stop_token>

namespace app {

/// How far a task has advanced.
struct Progress {
    double share;       ///< 0 to 1
    double secondsLeft; ///< estimated from the time used so far
};

/// Stops and observes a task from outside; both members are optional. The working thread calls
/// `progress` after each step (some hundredths of a second).
struct Follower {
    std::stop_token stop{};
    std::function<void(const Progress&)> progress{};
};

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

/// Reports progress of a task that consists of many turns: of about the same length, or each as
/// long as so many of them.
class TurnProgress {
public:
    TurnProgress(const Follower& follower, double turns);
    void turnDone(double turns = 1);
    bool stopped() const { return follower_.stop.stop_requested(); }

private:
    const Follower& follower_;
    Clock clock_ = wallClock();
    double start_, turns_, done_ = 0;
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stop_token>

namespace app {

/// How far some work has come.
struct Progress {
    double share;       ///< 0 to 1
    double secondsLeft; ///< as things went so far
};

/// Who follows some work from the outside; both may be left out. The thread that works calls
/// `progress` after each step (some hundredths of a second).
struct Follower {
    std::stop_token stop{};
    std::function<void(const Progress&)> progress{};
};

} // namespace app

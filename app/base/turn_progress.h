// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/clock.h"
#include "app/base/progress.h"

namespace app {

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

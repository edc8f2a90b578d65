// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_schedule.h"

namespace app {

FrameSchedule::Step FrameSchedule::start(Step step)
{
    painting_ = wanted_;
    fine_ = false;
    return step;
}

FrameSchedule::Step FrameSchedule::want(const FrameKey& key)
{
    if (wanted_ != key)
        wanted_ = key;
    if (!painting_)
        return isCurrent() ? Step::Nothing : start(Step::Start);
    if (!isLate())
        return Step::Nothing;
    if (isCurrent()) {
        painting_.reset();
        return Step::Cancel;
    }
    if (fine_)
        return start(Step::Replace);
    if (isSameBase(*painting_, key) || spares_)
        return Step::Nothing;
    spares_ = true;
    return start(Step::Replace);
}

FrameSchedule::Step FrameSchedule::rested()
{
    if (isLate())
        return start(Step::Replace);
    if (painting_ || !isRough())
        return Step::Nothing;
    start(Step::Start);
    fine_ = true;
    return Step::Start;
}

FrameSchedule::Step FrameSchedule::finished(bool rough)
{
    shown_ = std::move(painting_);
    painting_.reset();
    rough_ = rough;
    fine_ = spares_ = false;
    return isCurrent() ? Step::Nothing : start(Step::Start);
}

void FrameSchedule::forget() { *this = {}; }

} // namespace app

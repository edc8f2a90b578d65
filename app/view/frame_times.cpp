// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_times.h"

#include <algorithm>

namespace app {

void FrameStatistics::note(const FrameTimes& times)
{
    if (times.subject != subject_)
        forget();
    if (count_ > 0 && times.clipping == clipping_)
        return;
    subject_ = times.subject;
    clipping_ = times.clipping;
    times_[count_++ % length] = times.clipMs;
}

double FrameStatistics::median() const
{
    const std::size_t n = std::min(count_, length);
    if (n == 0)
        return 0;
    auto times = times_;
    std::sort(times.begin(), times.begin() + std::ptrdiff_t(n));
    return (times[(n - 1) / 2] + times[n / 2]) / 2;
}

} // namespace app

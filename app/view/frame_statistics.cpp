// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_statistics.h"

#include <algorithm>

namespace app {

void FrameStatistics::add(double milliseconds) { times_[count_++ % length] = milliseconds; }

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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/clock.h"

#include <chrono>
#include <ctime>

namespace app {

Clock wallClock()
{
    return {QStringLiteral("wall"), [] {
                const auto now = std::chrono::steady_clock::now().time_since_epoch();
                return std::chrono::duration<double, std::nano>(now).count();
            }};
}

Clock processorClock()
{
    return {QStringLiteral("processor time of the thread"), [] {
                timespec now{};
                ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
                return double(now.tv_sec) * 1e9 + double(now.tv_nsec);
            }};
}

} // namespace app

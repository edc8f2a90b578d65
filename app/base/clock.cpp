// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/clock.h"

#include <chrono>
#include <ctime>

namespace app {

std::uint64_t threadNanoseconds()
{
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return std::uint64_t(now.tv_sec) * 1'000'000'000 + std::uint64_t(now.tv_nsec);
}

Clock wallClock()
{
    return {QStringLiteral("wall"), [] {
                const auto now = std::chrono::steady_clock::now().time_since_epoch();
                return std::chrono::duration<double, std::nano>(now).count();
            }};
}

Clock processorClock()
{
    return {QStringLiteral("processor time of the thread"),
            [] { return double(threadNanoseconds()); }};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>

/// In milliseconds of processor time: what others do on the machine counts little.
inline double processorTime()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdio>
#include <fstream>
#include <malloc.h>
#include <string>

/// Bytes that are allocated now, with what malloc keeps beside each block.
inline std::size_t allocatedBytes()
{
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

/// Megabytes (10^6) of memory that this process has had at most; 0 where Linux does not say so.
inline double peakMegabytes()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (long kibibytes = 0; std::sscanf(line.c_str(), "VmHWM: %ld", &kibibytes) == 1)
            return double(kibibytes) * 1024e-6;
    return 0;
}

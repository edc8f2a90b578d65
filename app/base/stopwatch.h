// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/clock.h"

#include <cstdint>

namespace app {

/// Adds up the processor time that some work takes on its thread: a busy machine does not make it
/// longer.
class Stopwatch {
public:
    template <class Work>
    void time(const Work& work)
    {
        const std::uint64_t start = threadNanoseconds();
        work();
        sum_ += threadNanoseconds() - start;
    }
    void reset() { sum_ = 0; }
    std::uint64_t nanoseconds() const { return sum_; }

private:
    std::uint64_t sum_ = 0;
};

} // namespace app

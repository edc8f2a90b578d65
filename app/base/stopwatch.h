// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace app {

/// Adds up the time that some work takes.
class Stopwatch {
public:
    template <class Work>
    void time(const Work& work)
    {
        const auto start = std::chrono::steady_clock::now();
        work();
        sum_ += std::chrono::steady_clock::now() - start;
    }
    void reset() { sum_ = {}; }
    std::uint64_t nanoseconds() const
    {
        return std::uint64_t(std::chrono::duration_cast<std::chrono::nanoseconds>(sum_).count());
    }

private:
    std::chrono::steady_clock::duration sum_{};
};

} // namespace app

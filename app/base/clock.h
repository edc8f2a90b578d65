// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <functional>

namespace app {

/// The processor time that the calling thread has used.
std::uint64_t threadNanoseconds();

/// A source of times for measurements.
struct Clock {
    QString name;                        ///< written into reports
    std::function<double()> nanoseconds; ///< since a fixed moment; never decreases
};
Clock wallClock();
/// The processor time of the calling thread. Other programs do not disturb it, so it is the fairer
/// clock; but it does not count work that other threads or the graphics card do for the thread.
Clock processorClock();

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

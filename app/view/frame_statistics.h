// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace app {

/// Under so many lines a clip time says nothing.
constexpr std::size_t leastLinesToTime = 1000;

/// The middle of the last 60 times: what the status bar shows, so that one slow frame says nothing.
class FrameStatistics {
public:
    static constexpr std::size_t length = 60;

    void add(double milliseconds);
    void forget() { count_ = 0; }
    /// 0 without any; of an even number the mean of the two in the middle.
    double median() const;

private:
    std::array<double, length> times_{};
    std::size_t count_ = 0; ///< of all that came; the newest are times_[count_ % length] backwards
};

} // namespace app

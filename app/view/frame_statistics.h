// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/frame_times.h"

#include <array>
#include <cstddef>

namespace app {

/// With fewer lines a clip time is meaningless.
constexpr std::size_t leastLinesToTime = 1000;

/// The median of the last 60 times of the same clipping: of the same lines, at the same windows,
/// with the same variant. The status bar shows it, so that a single slow frame has no effect.
class FrameStatistics {
public:
    static constexpr std::size_t length = 60;

    /// Frames may be noted again, with news of their pictures. Another subject begins anew.
    void note(const FrameTimes& times);
    void forget() { count_ = 0; }
    /// 0 without times; for an even number the mean of the two middle times.
    double median() const;

private:
    std::array<double, length> times_{};
    std::size_t count_ = 0; ///< of all times noted; the newest are times_[count_ % length] and
                            ///< backwards
    std::uint64_t subject_ = 0, clipping_ = 0; ///< of the last one
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace app {

/// The number of another subject: no other one in the program has it.
inline std::uint64_t newSubject()
{
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

/// More lines that differ are not counted, and painted no sooner than all.
constexpr std::size_t mostDiffering = 20'000;

/// The times and numbers of a frame.
struct FrameTimes {
    double clipMs = 0; ///< processor time of clipping all lines
    double drawMs = 0; ///< of the picture that is seen: building and painting it
    std::size_t visible = 0, total = 0;
    /// Lines of the picture that are seen to be cut differently from `exact`: another part is left,
    /// or ends are off by more than 1/16 pixel. Counted to mostDiffering + 1; 0 where nothing is
    /// removed.
    std::size_t differing = 0;
    std::optional<Variant> choice{}; ///< the variant that clipped
    /// The new picture is not ready: what is finished of it is shown above the last one.
    bool painting = false;
    /// For how long other windows have been wanted than those at which the shown picture is cut; 0:
    /// it is up to date, or of another view.
    double lateMs = 0;
    std::uint64_t clipping = 0; ///< number of the clipping; another one has another time
    std::uint64_t subject = 0;  ///< number of what was clipped: the lines, windows and variant
};

/// A picture that is later than this is said to be late.
constexpr double longLate = 300;

/// With fewer lines a clip time is meaningless.
constexpr std::size_t leastLinesToTime = 1000;

/// The median of the last 60 times of the same clipping: of the same lines, at the same windows,
/// with the same variant. The status bar shows it, so that a single slow frame has no effect.
class FrameStatistics {
public:
    static constexpr std::size_t length = 60;

    /// Frames may be noted again, with news of their pictures. Another subject clears the figures.
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

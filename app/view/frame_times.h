// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"

#include <atomic>
#include <cstdint>
#include <optional>

namespace app {

/// The number of another subject: no other one in the program has it.
inline std::uint64_t newSubject()
{
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

/// The times and numbers of a frame.
struct FrameTimes {
    double clipMs = 0; ///< processor time of clipping all lines
    double drawMs = 0; ///< of the picture that is seen: building and painting it
    std::size_t visible = 0, total = 0;
    std::optional<Variant> choice{}; ///< the variant that clipped
    /// The new picture is not ready: what is finished of it is shown above the last one.
    bool painting = false;
    std::uint64_t clipping = 0; ///< number of the clipping; another one has another time
    std::uint64_t subject = 0;  ///< number of what was clipped: the lines, windows and variant
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <array>
#include <cstdint>
#include <optional>

// The bytes sent through the pipes between the judge and its child, which are the same program.

namespace app::plug_in {

/// One line to clip at one window.
struct Question {
    clipping::Segment line;
    clipping::Window window;
};
static_assert(sizeof(Question) == 64);

/// The output of the library's function.
struct Answer {
    std::array<double, 4> visible; ///< NaN where nothing was written
    std::int32_t returned;
    std::uint32_t wroteBeyond; ///< 1: the function wrote outside visible[0] to [3]

    std::optional<clipping::Segment> piece() const
    {
        if (returned == 0)
            return std::nullopt;
        return clipping::Segment{{visible[0], visible[1]}, {visible[2], visible[3]}};
    }
};
static_assert(sizeof(Answer) == 40);

} // namespace app::plug_in

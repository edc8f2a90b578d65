// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"

#include <cstdint>
#include <optional>

namespace ui {

/// The times of the last frame. `drawMs` is everything but the clipping: building the picture and
/// painting it.
struct FrameTimes {
    double clipMs = 0, drawMs = 0;
    std::size_t visible = 0, total = 0;
    std::optional<app::Variant> choice{}; ///< the variant that clipped
    /// The new picture is not ready: the last one is shown, moved and scaled.
    bool painting = false;
};

} // namespace ui

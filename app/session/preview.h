// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/affine_map.h"
#include "app/document/clip_windows.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace app {

/// The change that the current gesture or dialog would make if it ended now. Views show the
/// document with this change. A gesture on a clip window, the Line tool and the dialog Repeat
/// selection set it; other tools paint their own.
struct Preview {
    /// What the gesture does to the clip window.
    enum class Drag : std::uint8_t { None, Moving, Sizing, Rotating };

    std::optional<ClipWindows> windows{}; ///< empty: the document's
    Drag drag = Drag::None;
    double angle = 0; ///< by which the clip window was rotated; radians, from x towards y
    std::optional<clipping::Segment> line{}; ///< the line being drawn
    std::vector<AffineMap> copies{};         ///< of the selection, that would be added

    friend bool operator==(const Preview&, const Preview&) = default;
};

} // namespace app

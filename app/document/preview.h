// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <cstdint>
#include <optional>

namespace app {

/// What the gesture in hand would leave if it ended now, and what the document does not have yet.
/// It is plain data: whoever shows something of the document shows it with the preview in it.
struct Preview {
    /// What the gesture does to the clip window.
    enum class Drag : std::uint8_t { None, Moving, Sizing };

    std::optional<clipping::Window> window{}; ///< nothing: the document's
    Drag drag = Drag::None;
    std::optional<clipping::Segment> line{}; ///< being drawn

    friend bool operator==(const Preview&, const Preview&) = default;
};

} // namespace app

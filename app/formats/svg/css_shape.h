// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/formats/svg/transform.h"

#include <string_view>

namespace app::svg {

/// What `clip-path` says in CSS: "circle(9px at 50% 50%) fill-box", or one of its parts.
struct CssClip {
    std::string_view function{}, arguments{}; ///< "circle", "9px at 50% 50%"; empty: the box itself
    std::string_view box{};                   ///< "fill-box"; empty: none is named
};
std::optional<CssClip> parseCssClip(std::string_view text); ///< empty: it is none

/// The area of a shape of CSS in a box; empty if it is not understood.
std::optional<PathShape> cssShape(const CssClip& clip, const Box& box, const Lengths& lengths);

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"
#include "app/document/style.h"

#include <vector>

namespace app {

/// How much of a box a set of points contains.
enum class Share : std::uint8_t { None, All, Some };

/// How much of a box is inside closed rings. None and All are never wrong; Some also where rounding
/// does not allow to tell, and for more than `mostEdgesForBoxes` edges, which would take longer
/// than clipping what is in the box. The box must be finite and not inverted.
Share shareOfBox(const std::vector<std::vector<Point>>& rings, FillRule rule,
                 const clipping::Window& box);
inline constexpr std::size_t mostEdgesForBoxes = 256;

} // namespace app

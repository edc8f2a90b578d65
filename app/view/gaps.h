// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <span>
#include <vector>

namespace app {

/// Appends what is missing of a line, in its order. `kept` is what is there, likewise; `source` is
/// put into every gap. A gap begins and ends where kept pieces do, bit for bit. For one piece these
/// are the rules of `clipping::outsideAll`: a single point of a longer line is no piece, and one
/// that runs the other way (a published form) is turned.
void appendGaps(const clipping::Segment& line, std::uint32_t source,
                std::span<const clipping::Clipped> kept, std::vector<clipping::Clipped>& gaps);

} // namespace app

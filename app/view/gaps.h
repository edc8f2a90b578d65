// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <span>
#include <vector>

namespace app {

/// Appends the missing parts of a line, in order. `kept` are the parts that are present, in order;
/// `source` is stored in every gap. A gap begins and ends bit for bit where kept pieces do. For a
/// single piece the rules are those of `clipping::outsideAll`: a single point of a longer line is
/// no gap, and a piece in reverse direction (from a published form) is turned round.
void appendGaps(const clipping::Segment& line, std::uint32_t source,
                std::span<const clipping::Clipped> kept, std::vector<clipping::Clipped>& gaps);

} // namespace app

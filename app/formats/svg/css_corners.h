// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/transform.h"

#include <array>
#include <string_view>

namespace app::svg {

/// The radii of the corners of a box: top left, top right, bottom right, bottom left.
using CornerRadii = std::array<Point, 4>;

/// "5px 10% / 3px", for a box of this size: as in border-radius, and made smaller where they would
/// overlap. Empty if it is not understood.
std::optional<CornerRadii> cornerRadii(std::string_view text, const Point& size,
                                       const Lengths& lengths);

/// The outline of a box with such corners.
Subpath roundedBox(const Box& box, const CornerRadii& radii);

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/path_data.h"

namespace app::svg {

/// A place at which a path has a marker: the start of all, the end of all, or any vertex between.
struct MarkerVertex {
    enum class Kind : std::uint8_t { Start, Mid, End };
    Point at{};
    Kind kind = Kind::Mid;
    double angle = 0; ///< radians: half way between the directions in which the path comes and goes
};
std::vector<MarkerVertex> markerVertices(const Outline& outline);

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <string_view>

namespace app::svg {

/// What an attribute "d" or "points" draws.
struct Outline {
    std::vector<Subpath> paths;
    bool damaged = false; ///< it ends in something that is not understood: what was before is here
};

/// The whole grammar of path data. Arcs and quadratic curves become cubic ones. A line without
/// length alone becomes a path without segments (a dot); moves that draw nothing are left out.
/// Throws Refused where a coordinate is not finite.
Outline parsePathData(std::string_view text);

/// The points of a polyline or polygon.
enum class Ending : std::uint8_t { Open, Closed };
Outline parsePoints(std::string_view text, Ending ending);

/// How a path without segments is drawn and kept: see above. Used for <line> as well.
Subpath lineBetween(const Point& from, const Point& to);

} // namespace app::svg

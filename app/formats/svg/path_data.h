// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recipe.h"

#include <string_view>

namespace app::svg {

/// The outline described by an attribute "d" or "points".
struct Outline {
    std::vector<Subpath> paths;
    bool damaged = false;  ///< the text has an error; `paths` is what precedes the error
    bool sizeless = false; ///< a rectangle, circle or ellipse of size 0 or less, which has no path
    /// A segment that ends inside an arc: arcs are made of several curves.
    struct Joint {
        std::size_t path, segment;
    };
    std::vector<Joint> joints{};
    Recipe recipe{}; ///< of a rectangle, circle or ellipse
};

/// Parses the complete grammar of path data. Arcs and quadratic curves become cubic curves. A
/// single line of length zero becomes a path without segments (a dot); moves that draw nothing are
/// dropped. Throws Refused if a coordinate is not finite.
Outline parsePathData(std::string_view text);

/// Parses the points of a polyline or polygon.
enum class Ending : std::uint8_t { Open, Closed };
Outline parsePoints(std::string_view text, Ending ending);

/// The path of a <line>; a path without segments if it has length zero, as in path data.
Subpath lineBetween(const Point& from, const Point& to);

} // namespace app::svg

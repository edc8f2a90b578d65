// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"
#include "app/document/recipe.h"

#include <string>
#include <string_view>

// The recipe of a path, as an attribute of its element, in user units:
// clearcut:recipe="rectangle 1 2 30 40" gives its corner and size, "rectangle 1 2 30 40 5 0.5" also
// the radius of its corners and the angle in radians by which it is turned about its centre,
// "ellipse 5 5 3 2" its centre and radii, perhaps with that angle, "star 5 5 9 4 0.5 7" its centre,
// both radii, the angle of its first corner in radians, and the number of its points (StarRecipe),
// "text 5 20 7 'Hershey Sans 1-stroke' One\nTwo" the start of the baseline, the height of capitals,
// the font and the text, with \n for a line break and \\ for a backslash. After the height may
// stand the direction of the baseline in radians, 1 for a mirrored text, and for
// an installed font 1, 2 or 3 for bold, italic or both.
// "outlines 5 20 7 'DejaVu Sans' 0123456789abcdef One" is a text in an installed font. The number
// before the text is a checksum of the path, because the font may be missing where it is read.

namespace app::svg {

/// The value of the attribute, escaped; "" without a recipe.
std::string textOf(const Recipe& recipe, const Path& path);

/// No recipe if the text is not one of the above, or if it does not make the path of `subpaths`.
/// Throws Refused as Scanner::number does.
Recipe readRecipe(std::string_view text, std::span<const Subpath> subpaths);

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recipe.h"

#include <string>
#include <string_view>

// The recipe of a path, as an attribute of its element, in user units:
// clearcut:recipe="rectangle 1 2 30 40" gives its corner and size, "rectangle 1 2 30 40 5" also the
// radius of its corners, "ellipse 5 5 3 2" its centre and radii, "star 5 5 9 4 0.5 7" its centre,
// both radii, the angle of its first corner in radians, and the number of its points (StarRecipe),
// "text 5 20 7 'Hershey Sans 1-stroke' One\nTwo" the start of the baseline, the height of capitals,
// the font and the text, with \n for a line break and \\ for a backslash.

namespace app::svg {

/// The value of the attribute, escaped; "" without a recipe.
std::string textOf(const Recipe& recipe);

/// No recipe if the text is not one of the above. Throws Refused as Scanner::number does.
Recipe readRecipe(std::string_view text);

} // namespace app::svg

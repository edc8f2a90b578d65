// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recipe.h"

#include <string>
#include <string_view>

// What made a path, as an attribute of its element: clearcut:recipe="rectangle 1 2 30 40" is its
// corner and its size, "ellipse 5 5 3 2" its centre and its radii, in user units.

namespace app::svg {

/// "" for none, and for those that nothing draws yet.
std::string textOf(const Recipe& recipe);

/// None if the text is not one of the above. Throws Refused as Scanner::number does.
Recipe readRecipe(std::string_view text);

} // namespace app::svg

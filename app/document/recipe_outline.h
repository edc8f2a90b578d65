// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recipe.h"

#include <optional>
#include <span>

namespace app {

/// The outline of a rectangle, an ellipse, a regular polygon or a star; empty without
/// a recipe, and for a text (app/lettering).
std::optional<Subpath> outlineOf(const Recipe& recipe);

/// Whether both have the same points, apart from rounding.
bool alike(std::span<const Subpath> a, std::span<const Subpath> b);

/// Whether the subpaths are the recipe's outline, apart from rounding.
bool makes(const Recipe& recipe, std::span<const Subpath> subpaths);

} // namespace app

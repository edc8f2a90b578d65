// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recipe.h"

#include <optional>
#include <span>

namespace app {

/// The outline that a recipe makes: of a rectangle with sharp corners, or of an ellipse. Nothing
/// draws the others yet.
std::optional<Subpath> outlineOf(const Recipe& recipe);

/// Whether the subpaths are what the recipe makes, but for roundings.
bool makes(const Recipe& recipe, std::span<const Subpath> subpaths);

} // namespace app

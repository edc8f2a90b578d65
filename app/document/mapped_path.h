// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/affine_map.h"
#include "app/document/path.h"
#include "app/document/recipe.h"

namespace app {

Path mapped(const Path& path, const AffineMap& map);

/// Transforms a path and its recipe together. A path with a recipe stays the recipe's outline: a
/// rotated or mirrored one would begin at another corner.
void transform(Path& path, Recipe& recipe, const AffineMap& map);

} // namespace app

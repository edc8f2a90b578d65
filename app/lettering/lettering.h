// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recipe.h"

#include <QStringList>

#include <span>

namespace app {

/// A longer text is not edited, and no file may ask for it.
constexpr qsizetype longestText = 10'000;
/// From one baseline to the next, in heights of capital letters.
constexpr double linePitch = 1.7;

/// A text as paths. The size of the recipe is the height of its capital letters.
struct Lettering {
    std::vector<Subpath> paths{};
    QStringList missing{}; ///< each character that the font lacks, once; a box stands in its place
};
/// Empty if there is no such font, or the text is too long or too large.
Lettering lettered(const TextRecipe& text);

/// One sentence that names the letters that the font lacks; empty if it has all.
QString missingText(const Lettering& lettering);

/// Whether the subpaths are those of the text, apart from rounding.
bool makes(const TextRecipe& text, std::span<const Subpath> subpaths);

} // namespace app

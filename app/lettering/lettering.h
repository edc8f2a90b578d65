// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recipe.h"
#include "app/document/subpath.h"

#include <QStringList>

#include <span>

namespace app {

/// From one baseline to the next, in heights of capital letters.
constexpr double linePitch = 1.7;

/// A text as paths in units of its font: y down, from the start of the first baseline.
struct Letters {
    double capital = 1; ///< the height of capital letters
    std::vector<Subpath> paths{};
    QStringList missing{}; ///< each character that the font lacks, once; a box stands in its place
};

/// A longer text is not edited, and no file may ask for it.
constexpr qsizetype longestText = 10'000;
constexpr double usualTextSize = 5; ///< of a new text, in millimetres on paper

/// A text as paths. The size of the recipe is the height of its capital letters.
struct Lettering {
    std::vector<Subpath> paths{};
    QStringList missing{}; ///< each character that the font lacks, once; a box stands in its place
};
/// Empty if there is no such font, or the text is too long or too large. Letters of an installed
/// font only on the main thread.
Lettering lettered(const TextRecipe& text);

/// The unit vectors along the baseline and from the letters to the next line.
Point alongOf(const TextRecipe& text);
Point downOf(const TextRecipe& text);

/// One sentence that names the letters that the font lacks; empty if it has all.
QString missingText(const Lettering& lettering);
/// That this font is not installed, and which one replaces it.
QString missingFontText(const QString& font);

/// Whether the subpaths are those of the text, apart from rounding.
bool makes(const TextRecipe& text, std::span<const Subpath> subpaths);

} // namespace app

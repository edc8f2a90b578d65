// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <vector>

namespace app {

/// A letter of a stroke font as a part of a sign that the font lacks.
struct LetterPart {
    char32_t letter;
    double scale = 1;
    double rise = 0; ///< above its line, in the font's units
    double pull = 0; ///< to the left, over the part before it
};

/// A sign made of letters of the font, with further strokes.
struct ComposedLetter {
    char32_t character;
    std::vector<LetterPart> parts;
    /// About the middle of the first part on its line, in the font's units, y down.
    std::vector<std::vector<Point>> strokes{};
};

const ComposedLetter* findComposed(char32_t character); ///< null: it is not composed

} // namespace app

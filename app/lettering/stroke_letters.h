// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"
#include "app/lettering/lettering.h"
#include "app/lettering/stroke_fonts.h"

#include <optional>

namespace app {

/// The text in letters of open strokes.
Letters strokeLetters(const QString& text, const StrokeFont& font);

/// The strokes of a combining mark, in the units of HersheyGlyph, around (0, 0): they are drawn
/// above the letter, or below it if `below`.
struct Accent {
    char32_t mark;
    std::vector<std::vector<Point>> strokes;
    bool below = false;
};

const Accent* findAccent(char32_t mark); ///< null: it is not known

} // namespace app

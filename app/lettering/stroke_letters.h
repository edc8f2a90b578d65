// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lettering/letters.h"
#include "app/lettering/stroke_fonts.h"

namespace app {

/// The text in letters of open strokes.
Letters strokeLetters(const QString& text, const StrokeFont& font);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lettering/lettering.h"

namespace app {

/// The text in the closed outlines of an installed font, with its curves, kerning and ligatures.
/// They are meant to be filled by the rule `nonzero`. Only for a family of `outlineFonts()`.
Letters outlineLetters(const QString& text, const QString& family, const FontFace& face = {});

} // namespace app

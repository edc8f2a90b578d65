// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <map>

class QRawFont;

namespace app {

// Qt places letters to 1/64 pixel; a line of 10,000 letters must stay below 2^25 pixels.
constexpr int pixelsPerEm = 1000;
constexpr double usualCapital = 0.7; ///< of the em, for a font without capitals

/// The height of capital letters, in the font's pixels.
double capitalOf(const QRawFont& font);

/// The outlines of a font's glyphs in its pixels, y down; each is looked up once. A frame stands
/// for a letter that the font lacks and draws nothing for.
class GlyphOutlines {
public:
    const std::vector<Subpath>& glyph(const QRawFont& font, unsigned index);

private:
    std::map<unsigned, std::vector<Subpath>> known_;
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"

#include <optional>
#include <string>
#include <string_view>

namespace app::svg {

/// Parses all notations for colours in SVG and CSS: names, transparent, #rgb #rgba #rrggbb
/// #rrggbbaa, and rgb() rgba() hsl() hsla() hwb() lab() lch() oklab() oklch() color() with numbers
/// or percentages and commas, blanks or a slash, and light-dark(), of which the first counts. Empty
/// for any other text, and for currentColor, which is not a colour yet.
std::optional<Colour> parseColour(std::string_view text);

/// "#8a5a2b"; with a fourth pair of digits if the colour is not opaque.
std::string hexOf(const Colour& colour);

/// Parses "0.5" or "50%"; the result is between 0 and 1.
std::optional<double> parseOpacity(std::string_view text);

/// The colour with its alpha multiplied by `opacity`.
Colour faded(Colour colour, double opacity);

} // namespace app::svg

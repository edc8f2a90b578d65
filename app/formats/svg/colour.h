// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

#include <optional>
#include <string_view>

namespace app::svg {

/// Every way to write a colour in SVG and CSS but currentColor, which is no colour yet: names,
/// transparent, #rgb #rgba #rrggbb #rrggbbaa, rgb() rgba() hsl() hsla() with numbers or percents
/// and commas, blanks or a slash. Nothing for anything else.
std::optional<Colour> parseColour(std::string_view text);

/// "0.5" or "50%", between 0 and 1.
std::optional<double> parseOpacity(std::string_view text);

/// The colour, seen through a further opacity.
Colour faded(Colour colour, double opacity);

} // namespace app::svg

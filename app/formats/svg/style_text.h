// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

#include <string>
#include <string_view>

namespace app::svg {

/// The style as presentation attributes, without those that have SVG's default value.
std::string styleText(const Style& style);

/// A colour as an attribute; the opacity is a separate one, NAME-opacity, as not every program
/// reads #rrggbbaa.
void appendPaint(std::string& text, std::string_view name, const std::optional<Colour>& colour);

} // namespace app::svg

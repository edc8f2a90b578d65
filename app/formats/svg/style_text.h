// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"

#include <QString>

#include <string>
#include <string_view>

namespace app::svg {

/// The style as presentation attributes, without those that have SVG's default value.
std::string styleText(const Style& style);

/// A colour as an attribute; the opacity is a separate one, NAME-opacity, as not every program
/// reads #rrggbbaa.
void appendPaint(std::string& text, std::string_view name, const std::optional<Colour>& colour);

} // namespace app::svg

namespace app::svg {

/// A style as CSS declarations: "fill:none;stroke:#ff0000;stroke-width:2". Reading it back gives
/// the same style.
QString declarations(const Style& style);

/// The style of declarations, with SVG's defaults for what they do not say. Empty: they are too
/// long, or not CSS.
std::optional<Style> styleOf(const QString& declarations);

} // namespace app::svg

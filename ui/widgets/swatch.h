// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"
#include "ui/look/look_icon.h"

namespace ui {

/// A colour as the drawing has it, without its opacity.
app::Colour plainColour(const QColor& colour);
QColor screenColour(const app::Colour& colour);

/// Paints a colour as it is in the drawing. It gets an outline where it is hardly visible on the
/// window (black in the dark look); no colour is a square with a stroke through it.
void paintSwatch(QPainter& painter, const QRect& square, const std::optional<app::Colour>& colour,
                 const Look& look);

/// Ring: of a stroke, beside the square of a fill.
enum class Swatch : std::uint8_t { Square, Ring };

/// The same as an icon of 16 logical pixels.
QIcon swatchIcon(const std::optional<app::Colour>& colour, Swatch form = Swatch::Square);
/// An icon for several colours.
QIcon mixedSwatchIcon();

} // namespace ui

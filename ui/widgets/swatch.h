// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"
#include "ui/look/look.h"

#include <QIcon>
#include <QPainter>

namespace ui {

/// Paints a colour as it is in the drawing. It gets an outline where it is hardly visible on the
/// window (black in the dark look); no colour is a square with a stroke through it.
void paintSwatch(QPainter& painter, const QRect& square, const std::optional<app::Colour>& colour,
                 const Look& look);

/// The same as an icon of 16 logical pixels.
QIcon swatchIcon(const std::optional<app::Colour>& colour, const Look& look);
/// An icon for several colours.
QIcon mixedSwatchIcon(const Look& look);

} // namespace ui

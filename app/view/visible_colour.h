// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"
#include "app/view/algorithm_mark.h"

namespace app {

/// The WCAG contrast ratio of two opaque colours, 1 to 21.
double contrast(const Colour& a, const Colour& b);

/// The colour in which a colour is shown on a page of the given colour: the colour itself if its
/// contrast is at least 3:1; otherwise with mirrored lightness and the same hue, adjusted further
/// if necessary. Alpha is kept.
Colour visibleColour(const Colour& colour, const Colour& page);

/// The colour mixed with the page colour at `opacity`, or at as much more as gives a contrast of
/// 3:1; the colour itself if no mix does. Alpha is kept.
Colour ghostColour(const Colour& colour, const Colour& page, double opacity);

/// A colour for a quantity from 0 to 1: the larger, the more it differs from the background.
/// Lightness is monotonic, so that the order is visible with any colour vision and in grey prints.
QColor sequentialColour(double share, Ground ground);

/// Black or white, whichever is more readable on the colour.
QColor readableOn(const QColor& colour);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

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

} // namespace app

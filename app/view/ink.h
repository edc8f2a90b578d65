// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

namespace app {

/// WCAG's contrast ratio of two opaque colours, 1 to 21.
double contrast(const Colour& a, const Colour& b);

/// How an ink is shown on a page of that colour: as it is where it can be seen (3:1), else with its
/// lightness mirrored, the hue kept, and if need be moved on until it can be. Alpha is kept.
Colour shownInk(const Colour& ink, const Colour& page);

/// An ink that is mixed with the page, with that opacity or as much more as it takes to be seen on
/// it (3:1); the ink itself if it cannot be. Alpha is kept.
Colour ghostInk(const Colour& ink, const Colour& page, double opacity);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/algorithm_mark.h"

namespace app {

/// A colour for a quantity from 0 to 1: the larger, the more it differs from the background.
/// Lightness is monotonic, so that the order is visible with any colour vision and in grey prints.
QColor sequentialColour(double share, Ground ground);

/// Black or white, whichever is more readable on the colour.
QColor readableOn(const QColor& colour);

} // namespace app

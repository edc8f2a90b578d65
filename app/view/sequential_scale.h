// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/algorithm_mark.h"

namespace app {

/// A colour for how much of something there is, from 0 to 1: the more, the farther from the ground.
/// Lightness goes one way only, so that all kinds of sight, and grey prints, can order it.
QColor sequentialColour(double share, Ground ground);

/// Black or white, whichever can be read on it.
QColor readableOn(const QColor& colour);

} // namespace app

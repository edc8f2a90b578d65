// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <QString>

namespace app {

/// "-100,-75,100,75": xmin, ymin, xmax and ymax, as the command line takes them. They read back bit
/// for bit, and are finite.
QString rectangleText(const clipping::Window& rectangle);

} // namespace app

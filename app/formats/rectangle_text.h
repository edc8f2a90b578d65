// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <QString>

namespace app {

/// "-100,-75,100,75": xmin, ymin, xmax and ymax as the command line accepts them. The numbers must
/// be finite, and read back bit for bit.
QString rectangleText(const clipping::Window& rectangle);

} // namespace app

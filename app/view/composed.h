// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/raster.h"

namespace app {

/// The rows of `band` of a frame that is put together from the picture of all lines, which does not
/// depend on the clip windows: as it is where `mask` (region_mask.h) is 255, with the opacity
/// `ghost`, 0 to 1, where it is 0, and in between where an edge crosses a pixel.
QImage composed(const QImage& drawing, const QImage& mask, Band band, double ghost);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region.h"
#include "app/view/raster.h"
#include "app/view/view.h"

namespace app {

/// Whether the mask of a region is painted in some milliseconds.
bool isMaskable(const ClipRegion& region);

/// How much of each device pixel the kept side of a region covers, 0 to 255, in an image of the
/// format Alpha8. Windows with a common edge leave no seam.
QImage regionMask(const ClipRegion& region, const View& view, const QSize& pixels,
                  double pixelRatio);

/// Opens a mask along strokes, which are painted on its edge, over their whole width.
void openAlong(QImage& mask, const DrawList& strokes, double pixelRatio);

/// Puts rows of a frame together from the same rows of the picture of all lines, which does not
/// depend on the clip windows: as they are where `mask` is 255, with the opacity `ghost`, 0 to 1,
/// where it is 0, and in between where an edge crosses a pixel. The images have the same size.
void compose(const QImage& drawing, const QImage& mask, double ghost, QImage& frame);

} // namespace app

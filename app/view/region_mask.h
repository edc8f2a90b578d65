// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region.h"
#include "app/view/draw_list.h"
#include "app/view/view.h"

#include <QImage>

namespace app {

/// Whether the mask of a region is painted in some milliseconds.
bool isMaskable(const ClipRegion& region);

/// How much of each device pixel the kept side of a region covers, 0 to 255, in an image of the
/// format Alpha8. Windows with a common edge leave no seam.
QImage regionMask(const ClipRegion& region, const View& view, const QSize& pixels,
                  double pixelRatio);

/// Opens a mask along strokes, which are painted on its edge, over their whole width.
void openAlong(QImage& mask, const DrawList& strokes, double pixelRatio);

} // namespace app

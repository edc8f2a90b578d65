// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_lines.h"
#include "app/view/picture_options.h"
#include "app/view/raster.h"

namespace app {

/// Whether a drawing consists of separate lines that are opaque, solid and at most one device pixel
/// wide, as the mass of every table of lines does.
bool hasOnlyHairlines(const SceneLines& lines, const StyleTable& styles,
                      const PictureOptions& options, double pixelRatio);

/// Paints all lines of such a drawing on a band, whatever the windows remove, straight from the
/// scene: a draw list (wholeDrawing) of millions of lines takes longer to build than to paint.
QImage paintedHairlines(const SceneLines& lines, const StyleTable& styles,
                        const PictureOptions& options, Band band, const RasterOptions& raster);

} // namespace app

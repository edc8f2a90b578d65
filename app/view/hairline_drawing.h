// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_lines.h"
#include "app/view/painted_part.h"
#include "app/view/picture_options.h"
#include "app/view/raster.h"

namespace app {

/// Whether a drawing consists of separate lines that are opaque, solid and at most one device pixel
/// wide, as the mass of every table of lines does.
bool hasOnlyHairlines(const SceneLines& lines, const StyleTable& styles,
                      const PictureOptions& options, double pixelRatio);

/// Paints a part of the lines of such a drawing above what is on a band, straight from the scene: a
/// draw list of millions of lines takes longer to build than to paint.
void paintHairlines(QImage& image, const SceneLines& lines, PaintedPart part,
                    const StyleTable& styles, const PictureOptions& options, Band band,
                    const RasterOptions& raster);

} // namespace app

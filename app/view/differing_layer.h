// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/differing_lines.h"
#include "app/view/raster.h"

namespace app {

/// Lines of which a row keeps other parts than `exact`, to be painted anew above a frame that shows
/// what `exact` keeps: so what a row loses is seen to be lost, and what it invents to be there.
struct DifferingLayer {
    Picture lines; ///< whole
    Picture parts; ///< the kept ones above the ghost

    bool isEmpty() const { return lines.kept.commands.empty(); }
};

/// `differing` are lines of the frame, in order.
DifferingLayer differingLayer(const StyleTable& styles, const SceneLines& lines,
                              const SceneFrame& frame, std::span<const FrameLine> differing,
                              const PictureOptions& options);

/// Paints the lines anew in a band. They lie above all others, of which nothing is seen in their
/// pixels.
void paintAnew(QImage& image, const DifferingLayer& layer, Band band, const RasterOptions& options);

} // namespace app

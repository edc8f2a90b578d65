// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/differing_lines.h"
#include "app/view/raster.h"

namespace app {

/// The parts of lines that a row keeps and `exact` does not, or the other way round, to be painted
/// anew above a frame that shows what `exact` keeps: a line that the row loses looks lost, and one
/// that it invents is there.
struct DifferingLayer {
    Picture removed; ///< what `exact` keeps
    Picture shown;   ///< what the row keeps, above the ghost of what `exact` does

    bool isEmpty() const { return shown.kept.commands.empty() && removed.kept.commands.empty(); }
};

/// `differing` are lines of both frames, in order.
DifferingLayer differingLayer(const StyleTable& styles, const SceneLines& lines,
                              const SceneFrame& row, const SceneFrame& exact,
                              std::span<const FrameLine> differing, const PictureOptions& options);

/// Replaces the parts in a band of the image. Other lines in the same pixels stay. Where such a
/// part covers a pixel completely the image does not tell whether others lie there, too: that is
/// guessed by the pixels on both sides.
void paintAnew(QImage& image, const DifferingLayer& layer, Band band, const RasterOptions& options);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_frame.h"
#include "app/scene/scene_lines.h"
#include "app/view/draw_list.h"
#include "app/view/picture_options.h"

namespace app {

/// The strokes of kept lines that run along an edge of an axis-aligned window, less than a device
/// pixel from it. A mask would show only the half of them that is on its side.
DrawList linesAlongEdges(const StyleTable& styles, const SceneLines& lines, const SceneFrame& frame,
                         const PictureOptions& options, double pixelRatio);

} // namespace app

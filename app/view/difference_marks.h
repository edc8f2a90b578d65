// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_lines.h"
#include "app/view/draw_list.h"
#include "app/view/picture_options.h"

namespace app {

/// The draw list for the marks `options.graded` and, above them, `options.differing`. Marks are
/// always thicker than the lines below them, and have ticks where these help.
DrawList differenceMarks(const StyleTable& styles, const SceneLines& lines,
                         const PictureOptions& options);

} // namespace app

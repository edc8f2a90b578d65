// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/picture.h"

namespace app {

/// What `options.graded`, and over it `options.differing`, look like: always thicker than the lines
/// that it lies upon, with ticks where they help.
Plate differenceMarks(const StyleTable& styles, const SceneLines& lines,
                      const PictureOptions& options);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_lines.h"
#include "app/session/window_in_hand.h"

#include <functional>

namespace app {

/// The line that shows most of clipping: the longest that the window cuts; if it cuts none, the
/// longest that is visible; else the first. Of equally long lines the first. Lines of the objects
/// `locked`, usually a grid, come after all others. There must be at least one line.
///
/// `enough` is asked now and then: once it is true, the best line found so far is the answer.
std::size_t lineToSee(const SceneLines& lines, const TracedWindow& window,
                      const ObjectRanges& locked, const std::function<bool()>& enough);

} // namespace app

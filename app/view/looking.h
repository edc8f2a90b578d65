// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/view.h"

namespace app {

/// The view in which to show a piece of a line: unchanged if the piece is clearly visible; moved if
/// it is large enough but elsewhere; otherwise zoomed so that its surroundings are visible too.
View lookingAt(const View& view, const clipping::Window& piece, const clipping::Window& clipWindow);

/// The view, moved so that part of the line is visible if no part was; never zoomed.
View bringing(const View& view, const clipping::Segment& line);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/view.h"

namespace app {

/// The view to look at a piece of a line in: as it is where the piece is well seen in it, moved
/// where it is large enough but elsewhere, and else zoomed so that its surroundings are seen too.
View lookingAt(const View& view, const clipping::Window& piece, const clipping::Window& clipWindow);

/// The view, moved so that something of the line is in it, if nothing was; never zoomed.
View bringing(const View& view, const clipping::Segment& line);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/handles.h"
#include "app/view/snapping/snapper.h"

namespace app {

/// A handle of a box that is dragged.
struct DraggedHandle {
    Handle handle;
    Point at;    ///< where it was
    Point fixed; ///< the point of the box that stays
    Proportion proportion = Proportion::Free;
};

/// What is left of a snap for a handle that was dragged by `by`: the handle of a side moves across
/// that side only, and in proportion it stays on the line through the fixed point. Then the sides
/// of the box pass through the place.
MovedSnap heldByHandle(const DraggedHandle& dragged, const Point& by, MovedSnap snap);

} // namespace app

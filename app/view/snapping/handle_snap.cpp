// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/handle_snap.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace app {
namespace {

bool movesAlong(const Handle& handle, int axis) { return (axis == 0 ? handle.x : handle.y) != 0; }

/// The factor nearest to the one without snapping with which a side reaches the place.
MovedSnap inProportion(const DraggedHandle& dragged, const Point& by, MovedSnap snap)
{
    const Point reach = dragged.at - dragged.fixed;
    const double free = glm::length(reach + by) / glm::length(reach);
    std::optional<double> best;
    int along = 0;
    for (int axis = 0; axis < 2; ++axis) {
        const bool aligned =
            std::ranges::find(snap.lines, axis, &AlignmentLine::axis) != snap.lines.end();
        if (reach[axis] == 0 || (!snap.place && !aligned))
            continue;
        const double factor = (reach + snap.by)[axis] / reach[axis];
        if (!best || std::abs(factor - free) < std::abs(*best - free)) {
            best = factor;
            along = axis;
        }
    }
    if (!best)
        return {by};
    std::erase_if(snap.lines, [&](const AlignmentLine& line) { return line.axis != along; });
    snap.by = reach * (*best - 1);
    return snap;
}

} // namespace

MovedSnap heldByHandle(const DraggedHandle& dragged, const Point& by, MovedSnap snap)
{
    if (dragged.proportion != Proportion::Free)
        return inProportion(dragged, by, std::move(snap));
    bool follows = false;
    for (int axis = 0; axis < 2; ++axis) {
        if (movesAlong(dragged.handle, axis)) {
            follows = follows || snap.by[axis] != by[axis];
            continue;
        }
        snap.by[axis] = by[axis];
        std::erase_if(snap.lines, [axis](const AlignmentLine& line) { return line.axis == axis; });
    }
    const bool isCorner = dragged.handle.x != 0 && dragged.handle.y != 0;
    return follows || isCorner ? snap : MovedSnap{by};
}

} // namespace app

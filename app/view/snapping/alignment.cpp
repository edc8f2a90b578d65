// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/alignment.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

using clipping::Window;

std::array<double, 3> edgesAndMiddle(const Window& box, int axis)
{
    return {box.min[axis], box.min[axis] + (box.max[axis] - box.min[axis]) / 2, box.max[axis]};
}

struct Match {
    double by;
    double at; // exactly the other box's
};

/// The smallest move along one axis that aligns the boxes.
std::optional<Match> match(const Window& box, const Window& other, int axis, double radius)
{
    std::optional<Match> best;
    for (const double own : edgesAndMiddle(box, axis))
        for (const double at : edgesAndMiddle(other, axis))
            if (const double by = at - own;
                std::abs(by) <= (best ? std::nexttoward(std::abs(best->by), 0.0L) : radius))
                best = Match{by, at};
    return best;
}

/// The room between the boxes along the other axis; negative: they overlap.
double distanceAlong(const Window& box, const Window& other, int along)
{
    return std::max(other.min[along] - box.max[along], box.min[along] - other.max[along]);
}

AlignmentLine lineAt(const Window& box, const Window& other, int axis, double at)
{
    const int along = 1 - axis;
    AlignmentLine line{axis, at, std::min(box.min[along], other.min[along]),
                       std::max(box.max[along], other.max[along])};
    if (distanceAlong(box, other, along) > 0) {
        line.gapFrom = std::min(box.max[along], other.max[along]);
        line.gapTo = std::max(box.min[along], other.min[along]);
    }
    return line;
}

} // namespace

Alignment align(const Window& box, std::span<const Window> others, double radius)
{
    const double same = 1e-9 * radius;
    Alignment alignment;
    std::array<std::optional<double>, 2> at;
    for (int axis = 0; axis < 2; ++axis) {
        std::optional<Match> best;
        for (const Window& other : others)
            if (const auto found = match(box, other, axis, radius);
                found && (!best || std::abs(found->by) < std::abs(best->by)))
                best = found;
        if (!best)
            continue;
        alignment.by[axis] = best->by;
        at[std::size_t(axis)] = best->at;
    }
    const Window moved{box.min + alignment.by, box.max + alignment.by};
    for (int axis = 0; axis < 2; ++axis) {
        const auto place = at[std::size_t(axis)];
        if (!place)
            continue;
        const Window* nearest = nullptr;
        const auto isOn = [&](double edge) { return std::abs(edge - *place) <= same; };
        for (const Window& other : others)
            if (std::ranges::any_of(edgesAndMiddle(other, axis), isOn)
                && (!nearest
                    || distanceAlong(moved, other, 1 - axis)
                           < distanceAlong(moved, *nearest, 1 - axis)))
                nearest = &other;
        if (nearest)
            alignment.lines.push_back(lineAt(moved, *nearest, axis, *place));
    }
    return alignment;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <span>

namespace app {

/// A closed box, rounded outwards to single precision: what lies in the numbers that it was made of
/// lies in it. It can prove that something is far from an edge, never that it is near one. All four
/// numbers are NaN if a number that it was made of was not finite: no comparison holds then.
struct FloatBox {
    float minX, minY, maxX, maxY;

    clipping::Window window() const { return {{minX, minY}, {maxX, maxY}}; }
};

/// Whether nothing that lies in the box lies in the window, and whether all of it does. A box of
/// NaNs is neither outside nor inside.
inline bool isOutside(const FloatBox& box, const clipping::Window& w)
{
    return box.maxX < w.min.x || box.minX > w.max.x || box.maxY < w.min.y || box.minY > w.max.y;
}
inline bool isInside(const FloatBox& box, const clipping::Window& w)
{
    return box.minX >= w.min.x && box.maxX <= w.max.x && box.minY >= w.min.y && box.maxY <= w.max.y;
}

/// The smallest such box around some segments, at least one.
FloatBox boxAround(std::span<const clipping::Segment> segments);
/// The smallest box around two.
FloatBox united(const FloatBox& a, const FloatBox& b);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <span>

namespace app {

/// A closed box, rounded outwards to single precision: it contains everything in the box of doubles
/// that it was made from. It can prove that something is far from an edge, never that it is near
/// one. All four numbers are NaN if any source number is not finite: then every comparison is
/// false.
struct FloatBox {
    float minX, minY, maxX, maxY;

    clipping::Window window() const { return {{minX, minY}, {maxX, maxY}}; }
};

/// Whether the box is entirely outside the window, or entirely inside it. A box of NaNs is neither.
inline bool isOutside(const FloatBox& box, const clipping::Window& w)
{
    return box.maxX < w.min.x || box.minX > w.max.x || box.maxY < w.min.y || box.minY > w.max.y;
}
inline bool isInside(const FloatBox& box, const clipping::Window& w)
{
    return box.minX >= w.min.x && box.maxX <= w.max.x && box.minY >= w.min.y && box.maxY <= w.max.y;
}

/// The smallest such box around the segments, of which there must be at least one.
FloatBox boxAround(std::span<const clipping::Segment> segments);
/// The smallest box around two boxes.
FloatBox united(const FloatBox& a, const FloatBox& b);

} // namespace app

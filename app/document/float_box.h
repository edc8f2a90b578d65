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

/// The smallest such box around some segments, at least one.
FloatBox boxAround(std::span<const clipping::Segment> segments);
/// The smallest box around two.
FloatBox united(const FloatBox& a, const FloatBox& b);

} // namespace app

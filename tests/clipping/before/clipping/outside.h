// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <span>

namespace clipping {

/// What the window removes: the parts of `in` outside it, given what `clipAll` found inside
/// (`inside`, for the same input and window). Writes to `out`, which does not overlap and holds
/// at least `in.size() + inside.size()` pieces; returns how many were written, in input order,
/// the piece at a's side first. The pieces reuse the inside's cut points bit for bit: inside and
/// outside together are the whole. A segment of which a single point is inside comes
/// back whole, once; a piece of a published form may run the other way; a part along an edge
/// belongs to the inside. Allocates nothing.
std::size_t outsideAll(std::span<const Segment> in, std::span<const Clipped> inside,
                       std::span<Clipped> out);

} // namespace clipping

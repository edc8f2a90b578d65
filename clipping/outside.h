// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <span>

namespace CLEARCUT_API clipping {

/// Computes what the window removes: the parts of `in` outside it, given the result `inside` of
/// `clipAll` for the same input and window. Writes to `out`, which must not overlap the inputs and
/// must hold at least `in.size() + inside.size()` pieces. Returns the number of pieces, written in
/// input order, of each segment the piece at a's side first. The pieces reuse the cut points of
/// `inside` bit for bit, so inside and outside together are the whole. A segment with a single
/// point inside is returned whole, once. A part along an edge belongs to the inside. A piece of a
/// published form may have the opposite direction. Allocates nothing.
std::size_t outsideAll(std::span<const Segment> in, std::span<const Clipped> inside,
                       std::span<Clipped> out) noexcept;

} // namespace clipping

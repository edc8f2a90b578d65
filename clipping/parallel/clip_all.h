// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <span>

namespace clipping {

/// From so many segments on, handing out the work to threads is worth its cost.
constexpr std::size_t parallelThreshold = 100'000;

/// What `clipAll` of the row `exact` does, with the same result bit for bit, on all threads of the
/// calling task arena (oneTBB; limit them with tbb::task_arena or tbb::global_control). Fewer
/// segments than `parallelThreshold` are clipped by the caller alone. All of `out` may be written
/// to, not only the pieces that are returned.
std::size_t clipAllInParallel(std::span<const Segment> in, const Window& window,
                              std::span<Clipped> out);
std::size_t clipAllInParallel(std::span<const BasicSegment<float>> in,
                              const BasicWindow<float>& window,
                              std::span<BasicClipped<BasicSegment<float>>> out);

} // namespace clipping

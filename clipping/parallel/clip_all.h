// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <span>

namespace CLEARCUT_API clipping {

/// The number of segments from which splitting the work among threads is faster.
constexpr std::size_t parallelThreshold = 500'000;

/// Does what `clipAll` of the row `exact` does, with the same result bit for bit, on all threads of
/// the calling task arena (oneTBB; limit them with tbb::task_arena or tbb::global_control). Fewer
/// than `parallelThreshold` segments are clipped on the calling thread alone. All of `out` may be
/// overwritten, not only the returned pieces.
std::size_t clipAllInParallel(std::span<const Segment> in, const Window& window,
                              std::span<Clipped> out);
std::size_t clipAllInParallel(std::span<const BasicSegment<float>> in,
                              const BasicWindow<float>& window,
                              std::span<BasicClipped<BasicSegment<float>>> out);

} // namespace clipping

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

namespace app {

/// Clips many segments of numbers T, as `clipAll` of the catalogue's rows.
template <class T>
using ClipAllOf = std::size_t (*)(std::span<const clipping::BasicSegment<T>> in,
                                  const clipping::BasicWindow<T>& window,
                                  std::span<clipping::BasicClipped<clipping::BasicSegment<T>>> out);

/// How many threads this machine can really run; one where the library was built without oneTBB.
std::size_t mostThreads();

/// What `clipAll` does, with the same result, on so many threads (at most mostThreads): each clips
/// its own part of the lines, and the pieces are moved together. The row `exact` has a way of its
/// own, the library's clipAllInParallel.
template <class T>
std::size_t clipInThreads(std::size_t threads, ClipAllOf<T> clipAll,
                          std::span<const clipping::BasicSegment<T>> in,
                          const clipping::BasicWindow<T>& window,
                          std::span<clipping::BasicClipped<clipping::BasicSegment<T>>> out);

} // namespace app

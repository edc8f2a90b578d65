// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

namespace app {

/// Clips many segments of number type T, like `clipAll` of the catalogue's algorithms.
template <class T>
using ClipAllOf = std::size_t (*)(std::span<const clipping::BasicSegment<T>> in,
                                  const clipping::BasicWindow<T>& window,
                                  std::span<clipping::BasicClipped<clipping::BasicSegment<T>>> out);

/// The number of threads that this machine can run; 1 if the library was built without oneTBB.
std::size_t mostThreads();

/// Does what `clipAll` does, with the same result, on `threads` threads (at most mostThreads): each
/// clips its own part of the lines, then the pieces are moved together. `exact` uses the library's
/// clipAllInParallel instead.
template <class T>
std::size_t clipInThreads(std::size_t threads, ClipAllOf<T> clipAll,
                          std::span<const clipping::BasicSegment<T>> in,
                          const clipping::BasicWindow<T>& window,
                          std::span<clipping::BasicClipped<clipping::BasicSegment<T>>> out);

} // namespace app

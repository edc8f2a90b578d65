// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"

#ifdef CLEARCUT_THREADS
#include "clipping/parallel/clip_all.h"

#include <tbb/task_arena.h>
#endif

namespace clipping::python {

/// clipAll of the row `exact`, on this many threads; 0: on all. Without oneTBB on one.
template <class T>
std::size_t exactOnThreads([[maybe_unused]] int threads, std::span<const BasicSegment<T>> in,
                           const BasicWindow<T>& window,
                           std::span<BasicClipped<BasicSegment<T>>> out)
{
#ifdef CLEARCUT_THREADS
    if (threads == 0)
        return clipAllInParallel(in, window, out);
    if (threads > 1)
        return tbb::task_arena(threads).execute([&] { return clipAllInParallel(in, window, out); });
#endif
    if constexpr (std::is_same_v<T, float>)
        return exactAlgorithm().floats->clipAll(in, window, out);
    else
        return exactAlgorithm().corrected.clipAll(in, window, out);
}

} // namespace clipping::python

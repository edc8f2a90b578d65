// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/threads.h"

#ifdef CLEARCUT_THREADS
#include "clipping/parallel/clip_all.h"

#include <algorithm>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <thread>
#include <vector>
#endif

namespace app {

#ifdef CLEARCUT_THREADS
namespace {

template <class T>
using Pieces = std::span<clipping::BasicClipped<clipping::BasicSegment<T>>>;

ClipAllOf<double> exactOf(double) { return clipping::exactAlgorithm().corrected.clipAll; }
ClipAllOf<float> exactOf(float) { return clipping::exactAlgorithm().floats->clipAll; }

/// Moves the pieces together: each part's pieces lie at the position of its lines.
template <class T>
std::size_t joined(std::size_t part, std::span<const std::size_t> counts, Pieces<T> out)
{
    std::size_t pieces = 0;
    for (std::size_t p = 0; p < counts.size(); ++p)
        for (std::size_t i = 0; i < counts[p]; ++i) {
            auto piece = out[p * part + i];
            piece.source += std::uint32_t(p * part);
            out[pieces++] = piece;
        }
    return pieces;
}

} // namespace

std::size_t mostThreads() { return std::max(std::thread::hardware_concurrency(), 1U); }

template <class T>
std::size_t clipInThreads(std::size_t threads, ClipAllOf<T> clipAll,
                          std::span<const clipping::BasicSegment<T>> in,
                          const clipping::BasicWindow<T>& window, Pieces<T> out)
{
    tbb::task_arena arena{int(threads)};
    if (clipAll == exactOf(T{}))
        return arena.execute([&] { return clipping::clipAllInParallel(in, window, out); });
    const std::size_t part = (in.size() + threads - 1) / threads;
    std::vector<std::size_t> counts(threads);
    const auto clipPart = [&](std::size_t p) {
        const std::size_t begin = std::min(p * part, in.size());
        const std::size_t count = std::min(part, in.size() - begin);
        counts[p] = clipAll(in.subspan(begin, count), window, out.subspan(begin, count));
    };
    arena.execute([&] { tbb::parallel_for(std::size_t(0), threads, clipPart); });
    return joined<T>(part, counts, out);
}
#else
std::size_t mostThreads() { return 1; }

template <class T>
std::size_t clipInThreads(std::size_t, ClipAllOf<T> clipAll,
                          std::span<const clipping::BasicSegment<T>> in,
                          const clipping::BasicWindow<T>& window,
                          std::span<clipping::BasicClipped<clipping::BasicSegment<T>>> out)
{
    return clipAll(in, window, out);
}
#endif

template std::size_t clipInThreads<double>(std::size_t, ClipAllOf<double>,
                                           std::span<const clipping::Segment>,
                                           const clipping::Window&, std::span<clipping::Clipped>);
template std::size_t
clipInThreads<float>(std::size_t, ClipAllOf<float>, std::span<const clipping::BasicSegment<float>>,
                     const clipping::BasicWindow<float>&,
                     std::span<clipping::BasicClipped<clipping::BasicSegment<float>>>);

} // namespace app

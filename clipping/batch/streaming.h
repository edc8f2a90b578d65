// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <cstdint>

// Streaming stores write past the caches. An ordinary store first reads the line that it changes
// into the caches: half of the traffic of an output that does not stay there. They pay where
// nothing is computed meanwhile (README.md). In an anonymous namespace, as lanes.h
// explains.

namespace clipping {
namespace {

/// Outputs that can become this large are streamed, in bytes: with their input they fill a cache of
/// 32 MiB.
constexpr std::size_t streamedSize = std::size_t{16} << 20;

#if defined(__x86_64__) && defined(__GNUC__)

/// Whether an array of up to `count` pieces is to be streamed.
template <class Piece>
inline bool isStreamed(const Piece* out, std::size_t count)
{
    return count >= streamedSize / sizeof *out && reinterpret_cast<std::uintptr_t>(out) % 8 == 0;
}

/// Stores a piece that is a whole segment; `finishStreaming` must follow before anybody reads it.
template <class S>
inline void stream(BasicClipped<S>* out, const S& segment, std::size_t source)
{
    static_assert(sizeof segment % 8 == 0 && sizeof *out == sizeof segment + 8);
    auto* to = reinterpret_cast<long long*>(out);
    for (std::size_t at = 0; at < sizeof segment; at += 8) {
        long long word; // not an array of them: it would become vectors and be taken apart again
        __builtin_memcpy(&word, reinterpret_cast<const char*>(&segment) + at, 8);
        __builtin_ia32_movnti64(to++, word);
    }
    __builtin_ia32_movnti64(to, static_cast<long long>(source)); // `cut`, the upper half, is 0
}

/// Makes the streamed pieces visible to other threads in the usual order.
inline void finishStreaming() { __builtin_ia32_sfence(); }

#else

template <class Piece>
inline bool isStreamed(const Piece*, std::size_t)
{
    return false;
}
template <class S>
inline void stream(BasicClipped<S>* out, const S& segment, std::size_t source)
{
    *out = {segment, static_cast<std::uint32_t>(source), 0};
}
inline void finishStreaming() {}

#endif

} // namespace
} // namespace clipping

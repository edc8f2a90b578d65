// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/limits.h"
#include "clipping/output.h"

#include <algorithm>
#include <array>

// How clip.cpp clips what is not one array, or goes elsewhere than into one: in blocks on the
// stack.

namespace clipping {

/// The number type of a segment, line or ray.
template <class S>
using NumberIn = std::remove_cvref_t<decltype(S::a.x)>;

template <class T, class N>
constexpr BasicSegment<T> converted(const BasicSegment<N>& s)
{
    return {glm::vec<2, T>(s.a), glm::vec<2, T>(s.b)};
}

/// Writes the pieces of a block of `size` segments into the output.
template <class T, class N>
void put(std::span<const BasicClipped<BasicSegment<N>>> found, std::size_t size, Progress at,
         const Output<T>& out)
{
    const auto before = static_cast<std::uint32_t>(at.segments);
    if (out.mask()) {
        std::fill_n(out.mask() + at.segments, size, std::uint8_t(0));
        for (const auto& piece : found)
            out.mask()[at.segments + piece.source] = 1;
    } else if (out.sources())
        for (const auto& piece : found)
            out.sources()[at.visible++] = before + piece.source;
    else
        for (const auto& piece : found)
            out.pieces()[at.visible++] = {converted<T>(piece.segment), before + piece.source,
                                          piece.cut};
}

/// Clips `count` segments, each of which `read` gives by its index, with `clip`: many at once from
/// an array into another with as much room, returning the number of pieces. Ends when the output
/// is full.
template <class T, class Read, class Clip>
Progress clipInBlocks(std::size_t count, const Output<T>& out, const Read& read, const Clip& clip)
{
    using S = decltype(read(0));
    using Piece = BasicClipped<BasicSegment<NumberIn<S>>>;
    constexpr std::size_t block = 256;
    std::array<S, block> segments;
    std::array<Piece, block> pieces;
    count = std::min(count, tooMany - 1);
    Progress done;
    while (true) {
        const std::size_t room = out.room() - (out.mask() ? done.segments : done.visible);
        const std::size_t size = std::min({block, count - done.segments, room});
        if (size == 0)
            return done;
        for (std::size_t i = 0; i < size; ++i)
            segments[i] = read(done.segments + i);
        const std::span<const Piece> found(
            pieces.data(), clip(std::span<const S>(segments.data(), size), pieces.data()));
        put(found, size, done, out);
        done.segments += size, done.visible += found.size();
    }
}

} // namespace clipping

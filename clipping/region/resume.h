// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/region.h"

namespace clipping {

/// `clipAll` of region.h for any method: `pieces.of(segment, source)` returns the kept pieces of a
/// segment, valid until the next call.
template <class Pieces>
RegionProgress clipEach(std::span<const Segment> in, Pieces& pieces, std::span<RegionPiece> out,
                        RegionProgress from)
{
    from.written = 0;
    for (; from.segment < in.size(); ++from.segment, from.piece = 0) {
        const auto source = static_cast<std::uint32_t>(from.segment);
        const std::span<const RegionPiece> kept = pieces.of(in[from.segment], source);
        for (; from.piece < kept.size(); ++from.piece) {
            if (from.written == out.size())
                return from;
            out[from.written++] = kept[from.piece];
        }
    }
    return from;
}

/// `clip` of region.h for such a method.
template <class Pieces>
std::vector<RegionPiece> piecesOf(const Segment& segment, Pieces& pieces)
{
    const std::span<const RegionPiece> kept = pieces.of(segment, 0);
    return {kept.begin(), kept.end()};
}

} // namespace clipping

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/painted_part.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace app {

using clipping::Clipped;

Remains PaintedPart::remains(std::size_t block, std::size_t chunk) const
{
    if (which_ == Painted::All)
        return Remains::Whole;
    const Remains kept = frame_.blocks[block].remains[chunk];
    if (which_ == Painted::Kept || kept == Remains::Pieces)
        return kept;
    return kept == Remains::Gone ? Remains::Whole : Remains::Gone;
}

PaintedPart::Pieces PaintedPart::pieces(std::size_t block, std::size_t chunk)
{
    const auto& [of, firstObject, firstLine, remains, pieces] = frame_.blocks[block];
    const std::size_t first = of->chunks[chunk].first, end = of->endOfChunk(chunk);
    const auto begin = std::ranges::lower_bound(pieces, first, {}, &Clipped::source);
    auto last = begin;
    while (last != pieces.end() && last->source < end)
        ++last;
    gaps_.clear();
    return painted(*of, first, end, Pieces(begin, last), gaps_);
}

PaintedPart::Pieces PaintedPart::painted(const SceneBlock& block, std::size_t first,
                                         std::size_t end, Pieces kept,
                                         std::vector<Clipped>& gaps) const
{
    if (which_ == Painted::Kept)
        return kept;
    auto next = kept.begin();
    for (std::size_t line = first; line < end; ++line) {
        const auto begin = next;
        while (next != kept.end() && next->source == line)
            ++next;
        appendGaps(block.segments[line], std::uint32_t(line), Pieces(begin, next), gaps);
    }
    return gaps;
}

bool PaintedPart::isWhole(std::size_t block, std::size_t first, std::size_t end) const
{
    const auto& [of, firstObject, firstLine, remains, pieces] = frame_.blocks[block];
    std::vector<Clipped> gaps;
    for (std::size_t chunk = of->chunkOf(first); first < end; ++chunk) {
        const std::size_t last = std::min(end, of->endOfChunk(chunk));
        const Remains here = this->remains(block, chunk);
        if (here == Remains::Gone)
            return false;
        if (here == Remains::Pieces) {
            const auto from = std::ranges::lower_bound(pieces, first, {}, &Clipped::source);
            const auto to = std::ranges::lower_bound(pieces, last, {}, &Clipped::source);
            gaps.clear();
            const Pieces mine = painted(*of, first, last, Pieces(from, to), gaps);
            if (mine.size() != last - first
                || std::ranges::any_of(mine, [](const Clipped& piece) { return piece.cut != 0; }))
                return false;
        }
        first = last;
    }
    return true;
}

std::size_t PaintedPart::expectedPieces() const
{
    if (which_ == Painted::All)
        return frame_.total;
    if (which_ == Painted::Kept)
        return frame_.visible;
    std::size_t pieces = frame_.total - frame_.visible;
    for (const SceneFrame::Block& block : frame_.blocks)
        pieces += block.pieces.size();
    return pieces;
}

using clipping::Clipped;
using clipping::Edge;
using clipping::Segment;

void appendGaps(const Segment& line, std::uint32_t source, std::span<const Clipped> kept,
                std::vector<Clipped>& gaps)
{
    Segment gap = line; // its b is set when the gap ends
    Edge from = Edge::NoEdge;
    bool touched = false;
    for (const Clipped& piece : kept) {
        Segment part = piece.segment;
        Edge enter = clipping::cutEdgeOfA(piece.cut), leave = clipping::cutEdgeOfB(piece.cut);
        if (part.a == part.b && line.a != line.b)
            continue;
        if (glm::dot(part.b - part.a, line.b - line.a) < 0) {
            std::swap(part.a, part.b);
            std::swap(enter, leave);
        }
        if (part.a != gap.a)
            gaps.push_back({{gap.a, part.a}, source, clipping::cutAt(from, enter)});
        gap.a = part.b;
        from = leave;
        touched = true;
    }
    if (!touched)
        gaps.push_back({line, source, 0});
    else if (gap.a != line.b)
        gaps.push_back({{gap.a, line.b}, source, clipping::cutAt(from, Edge::NoEdge)});
}

} // namespace app

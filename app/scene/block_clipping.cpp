// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/block_clipping.h"

#include "app/scene/box_remains.h"

#include <algorithm>
#include <cstring>

namespace app {

using clipping::Clipped;

namespace {

// Calls visit(first, end) for the lines of each run of chunks with Remains::Pieces. Returns the
// number of lines in chunks with Remains::Whole.
template <class Visit>
std::size_t forEachCut(const SceneBlock& block, std::span<const Remains> remains,
                       const Visit& visit)
{
    std::size_t whole = 0;
    for (std::size_t chunk = 0; chunk < remains.size();) {
        const Remains here = remains[chunk];
        const std::size_t first = block.chunks[chunk].first;
        while (chunk + 1 < remains.size() && remains[chunk + 1] == here)
            ++chunk;
        const std::size_t end = block.endOfChunk(chunk++);
        if (here == Remains::Whole)
            whole += end - first;
        else if (here == Remains::Pieces)
            visit(first, end);
    }
    return whole;
}

// Whether a piece is the line itself. Compares the ends, as published forms may report no cut and
// still change the line.
bool isWhole(const Clipped& piece, const clipping::Segment& line)
{
    return piece.cut == 0 && std::memcmp(&piece.segment, &line, sizeof line) == 0;
}

/// The pieces of one chunk.
struct InChunk {
    std::size_t pieces = 0; // the number of leading pieces that belong to this chunk
    std::size_t visible = 0;
    bool whole = true; // each of its lines is kept unchanged
};

InChunk inChunk(std::span<const Clipped> pieces, std::span<const clipping::Segment> lines,
                std::size_t first)
{
    InChunk all;
    for (const Clipped& piece : pieces) {
        const std::size_t line = piece.source - first;
        if (line >= lines.size())
            break;
        all.whole = all.whole && line == all.pieces && isWhole(piece, lines[line]);
        all.visible += all.pieces == 0 || piece.source != (&piece)[-1].source;
        ++all.pieces;
    }
    all.whole = all.whole && all.pieces == lines.size();
    return all;
}

} // namespace

void BlockClipping::start(const ClipRegion& region, ClipAll clipAll, const std::stop_token& stop)
{
    regionClipping_.start(region, clipAll, stop);
    start(region);
}

void BlockClipping::startAs(const BlockClipping& other)
{
    regionClipping_.startAs(other.regionClipping_);
    start(*other.region_);
}

void BlockClipping::start(const ClipRegion& region)
{
    region_ = &region;
    window_ =
        regionClipping_.isExact() && region.keep == Keep::Inside ? region.single() : std::nullopt;
    stopwatch_.reset();
    pieces_.clear();
    visible_ = 0;
}

/// Whether chunks are so small, because styles change all the time, that looking at their boxes
/// takes longer than clipping at a rectangle.
static bool hasTinyChunks(const SceneBlock& block)
{
    constexpr std::size_t fewLines = 4;
    return block.segments.size() < fewLines * block.chunks.size();
}

void BlockClipping::clip(SceneFrame::Block& frame, std::span<Remains> remains)
{
    if (window_ && !hasTinyChunks(*frame.block))
        clipNearEdges(frame, remains, *window_);
    else
        clipInRegion(frame, remains);
}

// For the algorithm `exact` and the inside of one window.
void BlockClipping::clipNearEdges(SceneFrame::Block& frame, std::span<Remains> remains,
                                  const clipping::Window& window)
{
    const std::span lines(frame.block->segments);
    const std::span room = pieces_.room(lines.size());
    const auto& exact = clipping::exactAlgorithm().corrected;
    std::size_t count = 0, whole = 0;
    stopwatch_.time([&] {
        findRemains(*frame.block, *region_, remains);
        whole = forEachCut(*frame.block, remains, [&](std::size_t first, std::size_t end) {
            const auto out = room.subspan(count, end - first);
            const std::size_t pieces =
                exact.clipAll(lines.subspan(first, end - first), window, out);
            for (Clipped& piece : out.first(first == 0 ? 0 : pieces))
                piece.source += std::uint32_t(first);
            count += pieces;
        });
    });
    frame.pieces = pieces_.keep(count);
    visible_ += whole + count;
}

void BlockClipping::clipInRegion(SceneFrame::Block& frame, std::span<Remains> remains)
{
    std::ranges::fill(remains, region_->everything() ? Remains::Whole : Remains::Pieces);
    if (regionClipping_.isExact() && !region_->everything()
        && !(window_ && hasTinyChunks(*frame.block)))
        stopwatch_.time([&] { findRemains(*frame.block, *region_, remains); });
    if (regionClipping_.atOneWindow()) {
        settle(frame, remains, clipAtOneWindow(*frame.block, remains));
        return;
    }
    folded_.clear();
    forEachCut(*frame.block, remains, [&](std::size_t first, std::size_t end) {
        regionClipping_.fold(std::span(frame.block->segments).subspan(first, end - first), first,
                             folded_);
    });
    const std::span room = pieces_.room(folded_.size());
    std::ranges::copy(folded_, room.begin());
    settle(frame, remains, room);
}

// Clips all lines near the window's border with one call, because each call prepares the polygon.
std::span<Clipped> BlockClipping::clipAtOneWindow(const SceneBlock& block,
                                                  std::span<const Remains> remains)
{
    const std::span lines(block.segments);
    const std::span room = pieces_.room(2 * lines.size());
    std::size_t runs = 0, count = 0;
    near_.clear();
    sources_.clear();
    forEachCut(block, remains, [&](std::size_t, std::size_t) { ++runs; });
    if (runs == 1) {
        forEachCut(block, remains, [&](std::size_t first, std::size_t end) {
            count = regionClipping_.clip(lines.subspan(first, end - first), first, room);
        });
        return room.first(count);
    }
    forEachCut(block, remains, [&](std::size_t first, std::size_t end) {
        near_.insert(near_.end(), lines.begin() + std::ptrdiff_t(first),
                     lines.begin() + std::ptrdiff_t(end));
        for (; first < end; ++first)
            sources_.push_back(std::uint32_t(first));
    });
    if (!near_.empty())
        count = regionClipping_.clip(near_, 0, room);
    for (Clipped& piece : room.first(count))
        piece.source = sources_[piece.source];
    return room.first(count);
}

// Classifies each chunk by its pieces, and keeps the pieces of chunks that are neither gone nor
// whole.
void BlockClipping::settle(SceneFrame::Block& frame, std::span<Remains> remains,
                           std::span<Clipped> room)
{
    const std::span lines(frame.block->segments);
    std::span pieces = room;
    auto kept = room.begin();
    for (std::size_t chunk = 0; chunk < remains.size(); ++chunk) {
        const std::size_t first = frame.block->chunks[chunk].first;
        const auto linesHere = lines.subspan(first, frame.block->endOfChunk(chunk) - first);
        if (remains[chunk] == Remains::Whole)
            visible_ += linesHere.size();
        if (remains[chunk] != Remains::Pieces)
            continue;
        const InChunk here = inChunk(pieces, linesHere, first);
        visible_ += here.visible;
        if (here.pieces == 0)
            remains[chunk] = Remains::Gone;
        else if (here.whole)
            remains[chunk] = Remains::Whole;
        else if (kept == pieces.begin())
            kept += std::ptrdiff_t(here.pieces);
        else
            kept = std::copy_n(pieces.begin(), here.pieces, kept);
        pieces = pieces.subspan(here.pieces);
    }
    frame.pieces = pieces_.keep(std::size_t(kept - room.begin()));
}

} // namespace app

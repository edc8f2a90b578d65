// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/long_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {
namespace {

using clipping::Clipped;
using clipping::Segment;

// std::hypot: squares could overflow.
double lengthOf(const Segment& s) { return std::hypot(s.b.x - s.a.x, s.b.y - s.a.y); }

/// Calls `visit(block, line, piece)` for each kept piece of a frame, in order, and
/// `pass(block, line)` after the pieces of each line.
template <class Visit, class Pass>
void forEachPiece(std::span<const SceneFrame::Block> blocks, const Visit& visit, const Pass& pass)
{
    for (std::size_t at = 0; at < blocks.size(); ++at) {
        const auto& [block, firstObject, firstLine, remains, pieces] = blocks[at];
        auto next = pieces.begin();
        for (std::size_t chunk = 0; chunk < block->chunks.size(); ++chunk)
            for (std::size_t line = block->chunks[chunk].first; line < block->endOfChunk(chunk);
                 ++line) {
                if (remains[chunk] == Remains::Whole)
                    visit(at, line, Clipped{block->segments[line], std::uint32_t(line), 0});
                for (; next != pieces.end() && next->source == line; ++next)
                    visit(at, line, *next);
                pass(at, line, block->chunks[chunk].style);
            }
    }
}

/// Finds the runs of the kept pieces of one subpath after the other, as joinRuns (app/cut/runs.h)
/// does, and marks the pieces of those that are too short.
class ShortRuns {
public:
    ShortRuns(const StyleTable& styles, double least) : styles_(styles), least_(least) {}

    void add(const Segment& line, const Segment& piece)
    {
        const bool goesOn = open_ && piece.a == line.a;
        if (!goesOn)
            runs_.push_back({dropped_.size(), dropped_.size(), 0, piece.a == line.a && isFirst_});
        runs_.back().end = dropped_.size() + 1;
        runs_.back().length += lengthOf(piece);
        dropped_.push_back(false);
        keptWhole_ = piece == line;
        opens_ = piece.b == line.b;
    }
    /// After the pieces of each line; `joined`: the next line continues the subpath.
    void pass(const Segment& line, StyleIndex style, bool joined)
    {
        if (isFirst_)
            start_ = line.a;
        isFirst_ = false;
        whole_ = whole_ && std::exchange(keptWhole_, false);
        open_ = std::exchange(opens_, false);
        if (!joined)
            finish(start_ == line.b && styles_[style].dashes.empty());
    }
    const std::vector<bool>& dropped() const { return dropped_; }
    bool any() const { return any_; }

private:
    struct Run {
        std::size_t first, end; ///< numbers of kept pieces
        double length;
        bool atStart; ///< it begins where the subpath does
    };
    void finish(bool closed)
    {
        if (!whole_) {
            if (closed && open_ && runs_.size() > 1 && runs_.front().atStart)
                runs_.front().length = runs_.back().length += runs_.front().length;
            for (const Run& run : runs_)
                if (run.length < least_) {
                    std::fill(dropped_.begin() + std::ptrdiff_t(run.first),
                              dropped_.begin() + std::ptrdiff_t(run.end), true);
                    any_ = true;
                }
        }
        runs_.clear();
        isFirst_ = whole_ = true;
        open_ = false;
    }

    const StyleTable& styles_;
    double least_;
    std::vector<bool> dropped_; ///< for each kept piece of the frame
    std::vector<Run> runs_;     ///< of the current subpath
    glm::dvec2 start_{};
    bool isFirst_ = true, whole_ = true, any_ = false;
    bool open_ = false;  ///< the line before is kept up to its end
    bool opens_ = false; ///< so is the current one
    bool keptWhole_ = false;
};

/// Whether the line after this one continues its subpath.
bool joinsNext(std::span<const SceneFrame::Block> blocks, std::size_t at, std::size_t line)
{
    const SceneBlock& block = *blocks[at].block;
    const auto& end = block.segments[line].b;
    if (line + 1 < block.segments.size())
        return block.segments[line + 1].a == end
               && block.objectOf(line) == block.objectOf(line + 1);
    return at + 1 < blocks.size() && blocks[at + 1].block->continues
           && blocks[at + 1].block->segments.front().a == end;
}

} // namespace

LongPieces::LongPieces(const StyleTable& styles, const SceneFrame& frame, double least)
    : frame_(frame)
{
    ShortRuns runs(styles, least);
    const auto lineAt = [&](std::size_t at, std::size_t line) -> const Segment& {
        return frame.blocks[at].block->segments[line];
    };
    forEachPiece(
        frame.blocks,
        [&](std::size_t at, std::size_t line, const Clipped& piece) {
            runs.add(lineAt(at, line), piece.segment);
        },
        [&](std::size_t at, std::size_t line, StyleIndex style) {
            runs.pass(lineAt(at, line), style, joinsNext(frame.blocks, at, line));
        });
    if (runs.any())
        drop(runs.dropped());
}

// Chunks that are whole become pieces, because some of them may be dropped.
void LongPieces::drop(const std::vector<bool>& dropped)
{
    blocks_.assign(frame_.blocks.begin(), frame_.blocks.end());
    pieces_.resize(blocks_.size());
    std::size_t number = 0;
    forEachPiece(
        frame_.blocks,
        [&](std::size_t at, std::size_t, const Clipped& piece) {
            if (!dropped[number++])
                pieces_[at].push_back(piece);
        },
        [](std::size_t, std::size_t, StyleIndex) {});
    for (std::size_t at = 0; at < blocks_.size(); ++at) {
        remains_.emplace_back(blocks_[at].remains.begin(), blocks_[at].remains.end());
        std::ranges::replace(remains_[at], Remains::Whole, Remains::Pieces);
        blocks_[at].remains = remains_[at];
        blocks_[at].pieces = pieces_[at];
    }
    frame_.blocks = blocks_;
}

std::vector<Segment> withoutShortRings(std::vector<Segment> rings, double least)
{
    std::vector<Segment> longer;
    for (auto ring = rings.begin(); ring != rings.end();) {
        double length = lengthOf(*ring);
        auto end = ring + 1;
        for (; end != rings.end() && end->a == (end - 1)->b; ++end)
            length += lengthOf(*end);
        if (length >= least)
            longer.insert(longer.end(), ring, end);
        ring = end;
    }
    return longer;
}

} // namespace app

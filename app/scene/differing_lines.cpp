// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/differing_lines.h"

#include "app/base/background.h"
#include "app/base/in_parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace app {
namespace {

using clipping::Clipped;
using clipping::Segment;

bool areNear(const Point& p, const Point& q, double tolerance)
{
    return std::abs(p.x - q.x) <= tolerance && std::abs(p.y - q.y) <= tolerance;
}

/// The kept pieces of a chunk, one after another, without those that are too short.
class Kept {
public:
    /// `pieces` begins with those of the chunk if it has Remains::Pieces.
    Kept(const SceneBlock& block, std::size_t chunk, Remains remains,
         std::span<const Clipped> pieces, double tolerance)
        : block_(block), line_(block.chunks[chunk].first), end_(block.endOfChunk(chunk)),
          remains_(remains), pieces_(pieces), tolerance_(tolerance)
    {
        find();
    }

    bool isAtEnd() const { return remains_ == Remains::Gone || line_ == end_; }
    /// Whether the next piece is one of this line.
    bool isAt(std::size_t line) const { return !isAtEnd() && line_ == line; }
    std::size_t line() const { return isAtEnd() ? end_ : line_; }
    const Segment& segment() const
    {
        return remains_ == Remains::Whole ? block_.segments[line_] : pieces_.front().segment;
    }
    void next()
    {
        remains_ == Remains::Whole ? void(++line_) : void(pieces_ = pieces_.subspan(1));
        find();
    }
    /// The pieces of the chunks behind this one.
    std::span<const Clipped> rest() const { return pieces_; }

private:
    void find()
    {
        if (remains_ == Remains::Whole)
            while (line_ < end_ && isShort(block_.segments[line_]))
                ++line_;
        if (remains_ != Remains::Pieces)
            return;
        while (!pieces_.empty() && pieces_.front().source < end_
               && isShort(pieces_.front().segment))
            pieces_ = pieces_.subspan(1);
        line_ = pieces_.empty() ? end_ : std::min<std::size_t>(pieces_.front().source, end_);
    }
    bool isShort(const Segment& s) const { return areNear(s.a, s.b, tolerance_); }

    const SceneBlock& block_;
    std::size_t line_, end_;
    Remains remains_;
    std::span<const Clipped> pieces_;
    double tolerance_;
};

bool areSamePieces(const Segment& s, const Segment& t, double tolerance)
{
    return (areNear(s.a, t.a, tolerance) && areNear(s.b, t.b, tolerance))
           || (areNear(s.a, t.b, tolerance) && areNear(s.b, t.a, tolerance));
}

/// Calls `differs` for the lines of a chunk of which two frames keep different parts.
template <class Differs>
void compareChunks(Kept& a, Kept& b, double tolerance, const Differs& differs)
{
    while (!a.isAtEnd() || !b.isAtEnd()) {
        const std::size_t line = std::min(a.line(), b.line());
        bool isSame = true;
        for (; a.isAt(line) && b.isAt(line); a.next(), b.next())
            isSame = isSame && areSamePieces(a.segment(), b.segment(), tolerance);
        for (; a.isAt(line); a.next())
            isSame = false;
        for (; b.isAt(line); b.next())
            isSame = false;
        if (!isSame)
            differs(line);
    }
}

/// The lines of a block that differ; `found` counts those of all blocks.
std::vector<FrameLine> differingIn(const SceneFrame& a, const SceneFrame& b, std::size_t at,
                                   double tolerance, std::size_t most,
                                   std::atomic<std::size_t>& found)
{
    std::vector<FrameLine> lines;
    const SceneFrame::Block &inA = a.blocks[at], &inB = b.blocks[at];
    std::span<const Clipped> ofA = inA.pieces, ofB = inB.pieces;
    for (std::size_t chunk = 0; chunk < inA.remains.size() && found <= most; ++chunk) {
        const Remains remains = inA.remains[chunk];
        if (remains == inB.remains[chunk] && remains != Remains::Pieces)
            continue;
        Kept keptA(*inA.block, chunk, remains, ofA, tolerance);
        Kept keptB(*inB.block, chunk, inB.remains[chunk], ofB, tolerance);
        compareChunks(keptA, keptB, tolerance, [&](std::size_t line) {
            lines.push_back({at, line});
            ++found;
        });
        ofA = keptA.rest(), ofB = keptB.rest();
    }
    return lines;
}

} // namespace

std::vector<FrameLine> differingLines(const SceneFrame& a, const SceneFrame& b, double tolerance,
                                      std::size_t most)
{
    std::vector<std::vector<FrameLine>> inBlocks(a.blocks.size());
    std::atomic<std::size_t> found = 0;
    const auto compare = [&](std::size_t at, std::size_t) {
        inBlocks[at] = differingIn(a, b, at, tolerance, most, found);
    };
    inParallel(paintingThreads(), workersOf(paintingThreads()), inBlocks.size(), compare);
    std::vector<FrameLine> lines;
    for (const auto& inBlock : inBlocks)
        lines.insert(lines.end(), inBlock.begin(), inBlock.end());
    if (lines.size() > most)
        lines.resize(most + 1);
    return lines;
}

} // namespace app

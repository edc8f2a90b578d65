// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/same_frames.h"

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
    std::size_t line() const { return line_; }
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

bool areSameChunks(Kept& a, Kept& b, double tolerance)
{
    for (; !a.isAtEnd() && !b.isAtEnd(); a.next(), b.next()) {
        const Segment &s = a.segment(), &t = b.segment();
        const bool same = areNear(s.a, t.a, tolerance) && areNear(s.b, t.b, tolerance);
        const bool turned = areNear(s.a, t.b, tolerance) && areNear(s.b, t.a, tolerance);
        if (a.line() != b.line() || (!same && !turned))
            return false;
    }
    return a.isAtEnd() && b.isAtEnd();
}

bool areSameBlocks(const SceneFrame::Block& a, const SceneFrame::Block& b, double tolerance)
{
    std::span<const Clipped> ofA = a.pieces, ofB = b.pieces;
    for (std::size_t chunk = 0; chunk < a.remains.size(); ++chunk) {
        const Remains remains = a.remains[chunk];
        if (remains == b.remains[chunk] && remains != Remains::Pieces)
            continue;
        Kept inA(*a.block, chunk, remains, ofA, tolerance);
        Kept inB(*b.block, chunk, b.remains[chunk], ofB, tolerance);
        if (!areSameChunks(inA, inB, tolerance))
            return false;
        ofA = inA.rest(), ofB = inB.rest();
    }
    return true;
}

} // namespace

bool areSame(const SceneFrame& a, const SceneFrame& b, double tolerance)
{
    for (std::size_t i = 0; i < a.blocks.size(); ++i)
        if (!areSameBlocks(a.blocks[i], b.blocks[i], tolerance))
            return false;
    return true;
}

} // namespace app

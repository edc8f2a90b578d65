// SPDX-License-Identifier: GPL-3.0-or-later
#include <agg2/agg_clip_liang_barsky.h>

#include "tests/benchmarks/peers/lines.h"

// Anti-Grain Geometry's clip_line_segment: outcodes, then at most two moves of each end. (Its
// clip_liang_barsky is for polygons: it adds the corners that a line turns around, and so is no
// peer.)

namespace {

struct Agg {
    using Line = clipping::Segment;
    using Piece = clipping::Segment;
    using Box = agg::rect_d;
    static Line lineOf(const clipping::Segment& s) { return s; }
    static Box boxOf(const clipping::Window& w) { return {w.min.x, w.min.y, w.max.x, w.max.y}; }
    static clipping::Segment segmentOf(const Line& line) { return line; }
    static std::optional<Piece> clip(Line line, const Box& box)
    {
        const unsigned clipped =
            agg::clip_line_segment(&line.a.x, &line.a.y, &line.b.x, &line.b.y, box);
        return clipped < 4 ? std::optional(line) : std::nullopt; // 4: nothing is left
    }
};

} // namespace

std::span<const Peer> aggPeers()
{
    using Lines = PeerLines<Agg>;
    static const Peer all[] = {{"AGG clip_line_segment", "cohen-sutherland", "double",
                                Lines::prepare, doubleEnds, Lines::bytes}};
    return all;
}

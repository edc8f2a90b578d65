// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/edge_lines.h"

#include "app/view/stroke_list_builder.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using clipping::Clipped;
using clipping::Segment;

/// The edges of the axis-aligned windows.
class Edges {
public:
    /// `near` in user units.
    Edges(const ClipRegion& region, double near) : near_(near)
    {
        for (const ClipRegion::Step& step : region.steps)
            if (step.rings.empty())
                boxes_.push_back(step.box);
    }

    /// Whether something in the box may be near an edge.
    bool areNear(const FloatBox& box) const
    {
        const Point room(near_, near_);
        return std::ranges::any_of(boxes_, [&](const clipping::Window& w) {
            return !isOutside(box, {w.min - room, w.max + room})
                   && !isInside(box, {w.min + room, w.max - room});
        });
    }
    /// Whether a segment runs along an edge.
    bool runsAlong(const Segment& s) const
    {
        const bool level = std::abs(s.a.y - s.b.y) <= near_;
        const bool upright = std::abs(s.a.x - s.b.x) <= near_;
        if (level == upright) // neither, or no longer than a pixel
            return false;
        const int axis = level ? 1 : 0, along = 1 - axis;
        const auto [low, high] = std::minmax(s.a[along], s.b[along]);
        return std::ranges::any_of(boxes_, [&](const clipping::Window& w) {
            const bool isNear = std::abs(s.a[axis] - w.min[axis]) <= near_
                                || std::abs(s.a[axis] - w.max[axis]) <= near_;
            return isNear && high >= w.min[along] && low <= w.max[along];
        });
    }

private:
    std::vector<clipping::Window> boxes_;
    double near_;
};

} // namespace

DrawList linesAlongEdges(const StyleTable& styles, const SceneLines& lines, const SceneFrame& frame,
                         const PictureOptions& options, double pixelRatio)
{
    const Edges edges(*options.region, 1 / (options.view.zoom * pixelRatio));
    PaintedPart kept(frame, Painted::Kept);
    StrokeListBuilder builder(styles, lines, kept, options);
    std::vector<Clipped> along;
    for (std::size_t at = 0; at < lines.blocks().size(); ++at) {
        const SceneBlock& block = *lines.blocks()[at];
        for (std::size_t i = 0; i < block.chunks.size() && !options.stop.stop_requested(); ++i) {
            const SceneChunk& chunk = block.chunks[i];
            const Remains remains = kept.remains(at, i);
            if (remains == Remains::Gone || !edges.areNear(chunk.box))
                continue;
            along.clear();
            if (remains == Remains::Pieces)
                std::ranges::copy_if(
                    kept.pieces(at, i), std::back_inserter(along),
                    [&](const Clipped& piece) { return edges.runsAlong(piece.segment); });
            else
                for (std::size_t line = chunk.first; line < block.endOfChunk(i); ++line)
                    if (edges.runsAlong(block.segments[line]))
                        along.push_back({block.segments[line], std::uint32_t(line), 0});
            builder.add(at, i, along);
        }
    }
    return builder.take();
}

} // namespace app

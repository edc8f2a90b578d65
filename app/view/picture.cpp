// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/picture.h"

#include "app/view/difference_marks.h"
#include "app/view/ink.h"
#include "app/view/scene_plating.h"

#include <algorithm>

namespace app {
namespace {

constexpr double leastLit = 1.5; // pixels; least width of selected strokes

Plate plate(const StyleTable& styles, const SceneLines& lines, PaintedPart part,
            const PictureOptions& options)
{
    ScenePlating plating(lines, part, options, part.expectedPieces());
    std::optional<StyleIndex> style;
    for (std::size_t at = 0; at < lines.blocks().size(); ++at) {
        const SceneBlock& block = *lines.blocks()[at];
        for (std::size_t i = 0; i < block.chunks.size(); ++i) {
            const SceneChunk& chunk = block.chunks[i];
            const Remains remains = part.remains(at, i);
            if (remains == Remains::Gone)
                continue;
            if (style != chunk.style)
                plating.setStyle(styles[*(style = chunk.style)]);
            if (remains == Remains::Whole)
                plating.addWhole(at, i, chunk.first, block.endOfChunk(i));
            else
                plating.addPieces(at, part.pieces(at, i));
        }
    }
    return plating.take();
}

std::size_t objectsIn(std::span<const ObjectRange> ranges)
{
    std::size_t count = 0;
    for (const ObjectRange& range : ranges)
        count += range.size();
    return count;
}

/// Paints the selected objects whole, regardless of the clip windows.
class Lighting {
public:
    Lighting(const StyleTable& styles, const SceneLines& lines, const PictureOptions& options)
        : styles_(styles), lines_(lines), options_(options),
          plating_(lines, all_, options, objectsIn(options.selection))
    {
    }

    Plate plate()
    {
        for (const auto& [first, end] : options_.selection)
            lines_.forEachPart(lines_.firstLineOf(first), lines_.firstLineOf(end),
                               [&](auto run, auto from, auto to) { add(run, from, to); });
        return plating_.take();
    }

private:
    void add(std::size_t at, std::size_t first, std::size_t end)
    {
        const SceneBlock& block = *lines_.blocks()[at];
        for (std::size_t chunk = block.chunkOf(first); first < end; ++chunk) {
            const std::size_t last = std::min(end, block.endOfChunk(chunk));
            setStyle(block.chunks[chunk].style);
            plating_.addWhole(at, chunk, first, last);
            first = last;
        }
    }
    void setStyle(StyleIndex index)
    {
        if (index_ == index)
            return;
        index_ = index;
        style_ = styles_[index];
        style_.fill.reset();
        style_.stroke = options_.light;
        style_.width = std::max(style_.width, leastLit / options_.view.zoom);
        plating_.setStyle(style_);
    }

    const StyleTable& styles_;
    const SceneLines& lines_;
    const PictureOptions& options_;
    PaintedPart all_{{}, Painted::All};
    ScenePlating plating_;
    std::optional<StyleIndex> index_;
    Style style_;
};

// Areas keep the ghost's opacity; otherwise they would hide the kept part.
void makeGhosts(Plate& plate, const Ghosting& ghosting)
{
    for (Coat& coat : plate.coats)
        if (coat.stroke)
            coat.stroke->colour = ghostInk(coat.stroke->colour, ghosting.page, ghosting.opacity);
        else
            coat.fill.alpha = std::uint8_t(coat.fill.alpha * ghosting.opacity);
}

} // namespace

Picture picture(const StyleTable& styles, const SceneLines& lines, const SceneFrame& frame,
                const PictureOptions& options)
{
    const auto plateOf = [&](Painted part) {
        return plate(styles, lines, PaintedPart(frame, part), options);
    };
    const bool all = options.removed == RemovedPart::Shown;
    Picture picture;
    picture.kept = plateOf(all ? Painted::All : Painted::Kept);
    if (options.removed == RemovedPart::Ghosted)
        picture.ghost = plateOf(Painted::Removed);
    if (options.ghosting)
        makeGhosts(picture.ghost, *options.ghosting);
    picture.lit = Lighting(styles, lines, options).plate();
    picture.differing = differenceMarks(styles, lines, options);
    return picture;
}

} // namespace app

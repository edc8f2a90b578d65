// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/picture.h"

#include "app/view/difference_marks.h"
#include "app/view/scene_draw_list_builder.h"
#include "app/view/visible_colour.h"

#include <algorithm>

namespace app {
namespace {

constexpr double leastSelected = 1.5; // pixels; least width of selected strokes

DrawList drawList(const StyleTable& styles, const SceneLines& lines, PaintedPart part,
                  const PictureOptions& options)
{
    SceneDrawListBuilder builder(lines, part, options, part.expectedPieces());
    std::optional<StyleIndex> style;
    for (std::size_t at = 0; at < lines.blocks().size(); ++at) {
        const SceneBlock& block = *lines.blocks()[at];
        for (std::size_t i = 0; i < block.chunks.size(); ++i) {
            const SceneChunk& chunk = block.chunks[i];
            const Remains remains = part.remains(at, i);
            if (remains == Remains::Gone)
                continue;
            if (style != chunk.style)
                builder.setStyle(styles[*(style = chunk.style)]);
            if (remains == Remains::Whole)
                builder.addWhole(at, i, chunk.first, block.endOfChunk(i));
            else
                builder.addPieces(at, part.pieces(at, i));
        }
    }
    return builder.take();
}

std::size_t objectsIn(std::span<const ObjectRange> ranges)
{
    std::size_t count = 0;
    for (const ObjectRange& range : ranges)
        count += range.size();
    return count;
}

/// Paints the selected objects whole, regardless of the clip windows.
class SelectionPainter {
public:
    SelectionPainter(const StyleTable& styles, const SceneLines& lines,
                     const PictureOptions& options)
        : styles_(styles), lines_(lines), options_(options),
          builder_(lines, all_, options, objectsIn(options.selection))
    {
    }

    DrawList drawList()
    {
        for (const auto& [first, end] : options_.selection)
            lines_.forEachPart(lines_.firstLineOf(first), lines_.firstLineOf(end),
                               [&](auto run, auto from, auto to) { add(run, from, to); });
        return builder_.take();
    }

private:
    void add(std::size_t at, std::size_t first, std::size_t end)
    {
        const SceneBlock& block = *lines_.blocks()[at];
        for (std::size_t chunk = block.chunkOf(first); first < end; ++chunk) {
            const std::size_t last = std::min(end, block.endOfChunk(chunk));
            setStyle(block.chunks[chunk].style);
            builder_.addWhole(at, chunk, first, last);
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
        style_.width = std::max(style_.width, leastSelected / options_.view.zoom);
        builder_.setStyle(style_);
    }

    const StyleTable& styles_;
    const SceneLines& lines_;
    const PictureOptions& options_;
    PaintedPart all_{{}, Painted::All};
    SceneDrawListBuilder builder_;
    std::optional<StyleIndex> index_;
    Style style_;
};

// Areas keep the ghost's opacity; otherwise they would hide the kept part.
void makeGhosts(DrawList& drawList, const Ghosting& ghosting)
{
    for (DrawCommand& command : drawList.commands)
        if (command.stroke)
            command.stroke->colour =
                ghostColour(command.stroke->colour, ghosting.page, ghosting.opacity);
        else
            command.fill.alpha = std::uint8_t(command.fill.alpha * ghosting.opacity);
}

} // namespace

Picture picture(const StyleTable& styles, const SceneLines& lines, const SceneFrame& frame,
                const PictureOptions& options)
{
    const auto drawListOf = [&](Painted part) {
        return drawList(styles, lines, PaintedPart(frame, part), options);
    };
    const bool all = options.removed == RemovedPart::Shown;
    Picture picture;
    picture.kept = drawListOf(all ? Painted::All : Painted::Kept);
    if (options.removed == RemovedPart::Ghosted)
        picture.ghost = drawListOf(Painted::Removed);
    if (options.ghosting)
        makeGhosts(picture.ghost, *options.ghosting);
    picture.selected = SelectionPainter(styles, lines, options).drawList();
    picture.differing = differenceMarks(styles, lines, options);
    return picture;
}

} // namespace app

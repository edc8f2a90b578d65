// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/picture.h"

#include "app/scene/kept_box.h"
#include "app/view/difference_marks.h"
#include "app/view/long_pieces.h"
#include "app/view/scene_draw_list_builder.h"
#include "app/view/visible_colour.h"
#include "app/view/window_borders.h"

#include <algorithm>
#include <utility>

namespace app {
namespace {

// Around a selected stroke, in pixels: as wide as both sides of the band, and of its outline.
constexpr double band = 4, outlined = 6;

/// The images of layers, in the painting order of a scene's lines.
class ImagesAmongLines {
public:
    ImagesAmongLines(const SceneLines& lines, Painted part, const PictureOptions& options)
        : lines_(lines), part_(part), options_(options)
    {
    }

    /// The first line, up to `end`, that lies above the next image; `end` if no image does.
    std::size_t next(std::size_t end) const
    {
        const bool any = at_ < options_.underlays.size();
        return any ? std::min(end, lines_.firstLineOf(options_.underlays[at_].below)) : end;
    }
    /// Adds the images that have only the lines before this one below them.
    void addBelow(std::size_t line, SceneDrawListBuilder& builder)
    {
        for (; at_ < options_.underlays.size()
               && lines_.firstLineOf(options_.underlays[at_].below) <= line;
             ++at_)
            if (const SharedUnderlay shown = shownOf(options_.underlays[at_].underlay))
                builder.add(shown);
    }

private:
    // The removed part lies below the kept one.
    SharedUnderlay shownOf(const SharedUnderlay& image) const
    {
        return part_ == Painted::Kept && options_.region ? keptOf(image, *options_.region) : image;
    }

    const SceneLines& lines_;
    Painted part_;
    const PictureOptions& options_;
    std::size_t at_ = 0;
};

/// Adds the lines of a scene to a draw list, with the images among them.
class DrawListMaker {
public:
    DrawListMaker(const StyleTable& styles, const SceneLines& lines, PaintedPart part,
                  const PictureOptions& options)
        : styles_(styles), lines_(lines), part_(std::move(part)), options_(options),
          images_(lines, part_.which(), options),
          builder_(lines, part_, options, part_.expectedPieces())
    {
    }

    DrawList made()
    {
        for (std::size_t at = 0; at < lines_.blocks().size(); ++at) {
            const SceneBlock& block = *lines_.blocks()[at];
            const std::size_t before = lines_.runs()[at].firstLine;
            for (std::size_t i = 0; i < block.chunks.size() && !options_.stop.stop_requested();
                 ++i) {
                const std::size_t end = block.endOfChunk(i);
                for (std::size_t first = block.chunks[i].first; first < end;) {
                    images_.addBelow(before + first, builder_);
                    const std::size_t last = images_.next(before + end) - before;
                    add(at, i, first, last);
                    first = last;
                }
            }
        }
        images_.addBelow(lines_.size(), builder_);
        return builder_.take();
    }

private:
    // The lines [first, end) of a chunk, which no image divides.
    void add(std::size_t at, std::size_t i, std::size_t first, std::size_t end)
    {
        const StyleIndex index = lines_.blocks()[at]->chunks[i].style;
        const Remains remains = part_.remains(at, i);
        if (remains == Remains::Gone && !(options_.region && styles_[index].fill))
            return;
        if (style_ != index)
            builder_.setStyle(styles_[*(style_ = index)]);
        if (remains == Remains::Whole)
            return builder_.addWhole(at, i, first, end);
        const auto pieces = remains == Remains::Gone ? PaintedPart::Pieces() : part_.pieces(at, i);
        const auto from = std::ranges::lower_bound(pieces, first, {}, &clipping::Clipped::source);
        const auto to = std::ranges::lower_bound(pieces, end, {}, &clipping::Clipped::source);
        builder_.addPieces(at, i, first, end, {from, to});
    }

    const StyleTable& styles_;
    const SceneLines& lines_;
    PaintedPart part_;
    const PictureOptions& options_;
    ImagesAmongLines images_;
    SceneDrawListBuilder builder_;
    std::optional<StyleIndex> style_;
};

DrawList drawList(const StyleTable& styles, const SceneLines& lines, PaintedPart part,
                  const PictureOptions& options)
{
    return DrawListMaker(styles, lines, std::move(part), options).made();
}

std::size_t objectsIn(std::span<const ObjectRange> ranges)
{
    std::size_t count = 0;
    for (const ObjectRange& range : ranges)
        count += range.size();
    return count;
}

/// Paints a band below the selected objects, whole, regardless of the clip windows.
class BandPainter {
public:
    /// The band is `wider` than the strokes, in pixels.
    BandPainter(const StyleTable& styles, const SceneLines& lines, const PictureOptions& options,
                const Colour& colour, double wider)
        : styles_(styles), lines_(lines), options_(asGiven(options)), colour_(colour),
          wider_(wider / options.view.zoom / options.strokes),
          builder_(lines, all_, options_, objectsIn(options.selection))
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
    /// The page's own colour must not be made visible on the page.
    static PictureOptions asGiven(PictureOptions options)
    {
        options.page.reset();
        return options;
    }
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
        const Style& own = styles_[index];
        style_ = {
            .stroke = colour_, .width = (own.stroke ? own.width : 0) + wider_, .join = Join::Round};
        builder_.setStyle(style_);
    }

    const StyleTable& styles_;
    const SceneLines& lines_;
    PictureOptions options_;
    Colour colour_;
    double wider_; ///< user units
    PaintedPart all_{{}, Painted::All};
    SceneDrawListBuilder builder_;
    std::optional<StyleIndex> index_;
    Style style_;
};

DrawList selected(const StyleTable& styles, const SceneLines& lines, const PictureOptions& options)
{
    if (!outlines(lines, options.selection))
        return {};
    DrawList bands = BandPainter(styles, lines, options, options.light, outlined).drawList();
    bands.append(BandPainter(styles, lines, options, options.paper, band).drawList());
    return bands;
}

// Areas keep the ghost's opacity; otherwise they would hide the kept part.
void makeGhosts(DrawList& drawList, const Ghosting& ghosting)
{
    for (DrawCommand& command : drawList.commands)
        if (command.image)
            drawList.images[*command.image].opacity = ghosting.opacity;
        else if (command.stroke)
            command.stroke->colour =
                ghostColour(command.stroke->colour, ghosting.page, ghosting.opacity);
        else
            command.fill.alpha = std::uint8_t(command.fill.alpha * ghosting.opacity);
}

Picture pictureOf(const StyleTable& styles, const SceneLines& lines, const SceneFrame& frame,
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
    picture.selected = selected(styles, lines, options);
    picture.differing = differenceMarks(styles, lines, options);
    picture.borders = windowBorders(options);
    return picture;
}

} // namespace

bool outlines(const SceneLines& lines, std::span<const ObjectRange> selection)
{
    constexpr std::size_t mostObjects = 500, mostLines = 20'000;
    std::size_t objects = 0, count = 0;
    return std::ranges::all_of(selection, [&](const ObjectRange& range) {
        objects += range.size();
        if (objects <= mostObjects)
            count += lines.firstLineOf(range.end) - lines.firstLineOf(range.first);
        return objects <= mostObjects && count <= mostLines;
    });
}

DrawList wholeDrawing(const StyleTable& styles, const SceneLines& lines, const SceneFrame& frame,
                      const PictureOptions& options)
{
    return drawList(styles, lines, PaintedPart(frame, Painted::All), options);
}

Picture pictureAround(const StyleTable& styles, const SceneLines& lines,
                      const PictureOptions& options)
{
    return {.selected = selected(styles, lines, options),
            .ghost = {},
            .kept = {},
            .differing = differenceMarks(styles, lines, options),
            .borders = windowBorders(options)};
}

Picture picture(const StyleTable& styles, const SceneLines& lines, const SceneFrame& frame,
                const PictureOptions& options)
{
    if (options.leastLength > 0)
        return pictureOf(styles, lines, LongPieces(styles, frame, options.leastLength).frame(),
                         options);
    return pictureOf(styles, lines, frame, options);
}

} // namespace app

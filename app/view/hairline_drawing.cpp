// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/hairline_drawing.h"

#include "app/view/hairlines.h"
#include "app/view/visible_colour.h"
#include "clipping/algorithm.h"

#include <algorithm>
#include <optional>
#include <ranges>
#include <utility>

namespace app {
namespace {

using clipping::Segment;

/// How the lines of a style look.
struct HairlineLook {
    Colour colour{};
    double width = 0; ///< device pixels
    Cap cap{};
    friend bool operator==(const HairlineLook&, const HairlineLook&) = default;
};

HairlineLook lookOf(const Style& style, const PictureOptions& options, double pixelRatio)
{
    return {options.page ? visibleColour(*style.stroke, *options.page) : *style.stroke,
            strokeWidth(style, options) * pixelRatio, style.cap};
}

/// Calls visit(style) for each run of chunks of one style, until it returns false.
template <class Visit>
bool forEachStyle(const SceneLines& lines, const StyleTable& styles, const Visit& visit)
{
    std::optional<StyleIndex> last;
    for (const auto& block : lines.blocks())
        for (const SceneChunk& chunk : block->chunks)
            if (last != chunk.style && !visit(styles[*(last = chunk.style)]))
                return false;
    return true;
}

bool hasOneColour(const SceneLines& lines, const StyleTable& styles, const PictureOptions& options)
{
    std::optional<Colour> one;
    return forEachStyle(lines, styles, [&](const Style& style) {
        const Colour colour = lookOf(style, options, 1).colour;
        return std::exchange(one, colour).value_or(colour) == colour;
    });
}

/// Paints the lines of a band from the front to the back.
template <class Layer>
class HairlinePainting {
public:
    HairlinePainting(const PictureOptions& options, Band band, const RasterOptions& raster)
        : options_(options), raster_(raster), layer_(raster.width, band)
    {
        const double room = 2; // device pixels
        const auto toDrawing = [&](double x, double y) {
            return options.view.toDrawing(Point(x, y) / raster.pixelRatio);
        };
        near_ = {toDrawing(-room, band.top - room),
                 toDrawing(raster.width + room, band.top + band.height + room)};
    }

    void turnTo(const Style& style)
    {
        const HairlineLook look = lookOf(style, options_, raster_.pixelRatio);
        if (std::exchange(look_, look) != look)
            before_ = nullptr; // the same line in another colour lies above the one behind it
    }
    bool isNear(const SceneChunk& chunk) const { return !isOutside(chunk.box, near_); }
    void pass() { before_ = nullptr; } ///< over lines that are not near
    /// Adds the lines of a chunk.
    void add(std::span<const Segment> lines)
    {
        for (const Segment& line : lines | std::views::reverse)
            if (isNew(line))
                paint(line);
    }
    /// Adds pieces of a chunk of the block.
    void add(const SceneBlock& block, PaintedPart::Pieces pieces)
    {
        for (const clipping::Clipped& piece : pieces | std::views::reverse)
            if (isNew(block.segments[piece.source]))
                paint(piece.segment);
    }
    void paintOn(QImage& image) { layer_.paintOn(image); }

private:
    /// Whether the line that comes next, or a piece of it, repeats no line. A file may hold the
    /// same one a hundred thousand times, whose coverage must not add up.
    bool isNew(const Segment& line)
    {
        if (const Segment* const before = std::exchange(before_, &line); before != &line)
            repeats_ = before && before->a == line.a && before->b == line.b;
        return !repeats_;
    }
    void paint(const Segment& s)
    {
        if (std::max(s.a.x, s.b.x) < near_.min.x || std::min(s.a.x, s.b.x) > near_.max.x
            || std::max(s.a.y, s.b.y) < near_.min.y || std::min(s.a.y, s.b.y) > near_.max.y)
            return;
        auto line = hairlineOf(s);
        if (!line) // far beyond the view
            if (const auto seen = clipping::exactAlgorithm().corrected.clip(s, near_))
                line = hairlineOf(*seen);
        if (line)
            layer_.add(*line, look_.colour);
    }
    std::optional<Hairline> hairlineOf(const Segment& s) const
    {
        const Point a = options_.view.toScreen(s.a), b = options_.view.toScreen(s.b);
        return Hairline::of(QPointF(a.x, a.y) * raster_.pixelRatio,
                            QPointF(b.x, b.y) * raster_.pixelRatio, look_.width, look_.cap);
    }

    const PictureOptions& options_;
    const RasterOptions& raster_;
    Layer layer_;
    clipping::Window near_{}; ///< the band, slightly enlarged, in user units
    HairlineLook look_;
    const Segment* before_ = nullptr; ///< the line above
    bool repeats_ = false;            ///< it repeats the one above it
};

template <class Layer>
void paint(QImage& image, const SceneLines& lines, PaintedPart part, const StyleTable& styles,
           const PictureOptions& options, Band band, const RasterOptions& raster)
{
    HairlinePainting<Layer> painting(options, band, raster);
    std::optional<StyleIndex> last;
    for (std::size_t at = lines.blocks().size(); at-- > 0;) {
        const SceneBlock& block = *lines.blocks()[at];
        for (std::size_t i = block.chunks.size(); i-- > 0 && !raster.cancelled();) {
            const SceneChunk& chunk = block.chunks[i];
            const Remains remains = part.remains(at, i);
            if (remains == Remains::Gone || !painting.isNear(chunk)) {
                painting.pass();
                continue;
            }
            if (last != chunk.style)
                painting.turnTo(styles[*(last = chunk.style)]);
            if (remains == Remains::Pieces)
                painting.add(block, part.pieces(at, i));
            else
                painting.add(std::span(block.segments)
                                 .subspan(chunk.first, block.endOfChunk(i) - chunk.first));
        }
    }
    painting.paintOn(image);
}

} // namespace

bool hasOnlyHairlines(const SceneLines& lines, const StyleTable& styles,
                      const PictureOptions& options, double pixelRatio)
{
    const auto isSeparate = [](const auto& block) { return block->firstOfObject.empty(); };
    return std::ranges::all_of(lines.blocks(), isSeparate)
           && forEachStyle(lines, styles, [&](const Style& style) {
                  return style.stroke && style.stroke->alpha == 255 && !style.fill
                         && style.dashes.empty() && strokeWidth(style, options) * pixelRatio <= 1;
              });
}

void paintHairlines(QImage& image, const SceneLines& lines, PaintedPart part,
                    const StyleTable& styles, const PictureOptions& options, Band band,
                    const RasterOptions& raster)
{
    if (hasOneColour(lines, styles, options))
        paint<Hairlines>(image, lines, std::move(part), styles, options, band, raster);
    else
        paint<ColouredHairlines>(image, lines, std::move(part), styles, options, band, raster);
}

} // namespace app

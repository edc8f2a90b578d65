// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/hairline_drawing.h"

#include "app/view/hairlines.h"
#include "app/view/visible_colour.h"
#include "clipping/algorithm.h"

#include <algorithm>
#include <optional>

namespace app {
namespace {

using clipping::Segment;

/// How the lines of a style look.
struct HairlineLook {
    Colour colour;
    double width; ///< device pixels
    Cap cap;
    friend bool operator==(const HairlineLook&, const HairlineLook&) = default;
};

class HairlinePainting {
public:
    HairlinePainting(const PictureOptions& options, Band band, const RasterOptions& raster)
        : options_(options), band_(band), raster_(raster),
          image_(raster.width, band.height, QImage::Format_ARGB32_Premultiplied),
          tiles_(raster.width, band)
    {
        image_.fill(Qt::transparent);
        const double room = 2; // device pixels
        const auto toDrawing = [&](double x, double y) {
            return options.view.toDrawing(Point(x, y) / raster.pixelRatio);
        };
        near_ = {toDrawing(-room, band.top - room),
                 toDrawing(raster.width + room, band.top + band.height + room)};
    }

    bool isNear(const SceneChunk& chunk) const { return !isOutside(chunk.box, near_); }

    void turnTo(const Style& style)
    {
        const HairlineLook look{options_.page ? visibleColour(*style.stroke, *options_.page)
                                              : *style.stroke,
                                strokeWidth(style, options_) * raster_.pixelRatio, style.cap};
        if (look == look_)
            return;
        flush();
        look_ = look;
        before_ = nullptr; // the same line in another colour covers the one before it
    }
    /// Adds consecutive lines. One that repeats the line before it is left out: a file may hold the
    /// same one a hundred thousand times, whose coverage must not add up.
    void add(std::span<const Segment> lines)
    {
        for (const Segment& line : lines) {
            count(1);
            if (!before_ || before_->a != line.a || before_->b != line.b)
                paint(line);
            before_ = &line;
        }
    }
    /// Passes over lines outside the band. They count: it depends on no band what is painted in
    /// tiles.
    void pass(std::span<const Segment> lines)
    {
        count(lines.size());
        before_ = &lines.back();
    }
    QImage take()
    {
        flush();
        return std::move(image_);
    }

private:
    static constexpr std::size_t many = 64; // of one look: worth tiles

    void count(std::size_t lines)
    {
        count_ += lines;
        if (count_ < many || few_.empty())
            return;
        for (const Hairline& line : few_)
            tiles_.add(line);
        few_.clear();
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
        if (!line)
            return;
        if (count_ >= many)
            tiles_.add(*line);
        else
            few_.push_back(*line);
    }
    std::optional<Hairline> hairlineOf(const Segment& s) const
    {
        const Point a = options_.view.toScreen(s.a), b = options_.view.toScreen(s.b);
        return Hairline::of(QPointF(a.x, a.y) * raster_.pixelRatio,
                            QPointF(b.x, b.y) * raster_.pixelRatio, look_->width, look_->cap);
    }
    void flush()
    {
        for (const Hairline& line : few_)
            paintHairline(image_, band_.top, line, look_->colour);
        few_.clear();
        if (count_ >= many)
            tiles_.paintOn(image_, look_->colour);
        count_ = 0;
    }

    const PictureOptions& options_;
    const Band band_;
    const RasterOptions& raster_;
    QImage image_;
    Hairlines tiles_;
    clipping::Window near_{}; ///< the band, slightly enlarged, in user units
    std::optional<HairlineLook> look_;
    std::vector<Hairline> few_; ///< lines of this look as long as there are few
    std::size_t count_ = 0;     ///< of lines of this look
    const Segment* before_ = nullptr;
};

} // namespace

bool hasOnlyHairlines(const SceneLines& lines, const StyleTable& styles,
                      const PictureOptions& options, double pixelRatio)
{
    const auto isHairline = [&](const Style& style) {
        return style.stroke && style.stroke->alpha == 255 && !style.fill && style.dashes.empty()
               && strokeWidth(style, options) * pixelRatio <= 1;
    };
    std::optional<StyleIndex> last;
    for (const auto& block : lines.blocks()) {
        if (!block->firstOfObject.empty())
            return false;
        for (const SceneChunk& chunk : block->chunks)
            if (last != chunk.style && !isHairline(styles[*(last = chunk.style)]))
                return false;
    }
    return true;
}

QImage paintedHairlines(const SceneLines& lines, const StyleTable& styles,
                        const PictureOptions& options, Band band, const RasterOptions& raster)
{
    HairlinePainting painting(options, band, raster);
    std::optional<StyleIndex> last;
    for (const auto& block : lines.blocks())
        for (std::size_t i = 0; i < block->chunks.size() && !raster.cancelled(); ++i) {
            const SceneChunk& chunk = block->chunks[i];
            if (last != chunk.style)
                painting.turnTo(styles[*(last = chunk.style)]);
            const auto added =
                std::span(block->segments).subspan(chunk.first, block->endOfChunk(i) - chunk.first);
            painting.isNear(chunk) ? painting.add(added) : painting.pass(added);
        }
    return painting.take();
}

} // namespace app

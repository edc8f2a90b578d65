// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/composed_frame.h"

#include "app/scene/same_frames.h"
#include "app/view/edge_lines.h"
#include "app/view/region_mask.h"

#include <cstring>

namespace app {
namespace {

constexpr std::size_t slowLines = 25'000; // painted in more bands than there are threads

/// Whether the strokes are so thin, in device pixels, that a straight cut looks like that of a
/// mask.
bool areThin(const SceneLines& lines, const StyleTable& styles, const PictureOptions& options,
             double pixelRatio)
{
    constexpr double thin = 1.5;
    const double most = thin / (options.view.zoom * pixelRatio * options.strokes);
    std::optional<StyleIndex> last;
    for (const auto& block : lines.blocks())
        for (const SceneChunk& chunk : block->chunks) {
            if (last == chunk.style)
                continue;
            const Style& style = styles[*(last = chunk.style)];
            if (style.stroke && (style.width > most || (style.fill && options.closesAreas)))
                return false;
        }
    return options.leastWidth * options.strokes * pixelRatio <= thin;
}

} // namespace

bool ComposedFrame::canShow(const FrameWish& wish, const SceneFrame& frame,
                            const std::stop_token& stop)
{
    const PictureOptions options = wish.pictureOptions();
    const bool same = wish.key.variant.algorithm == &clipping::exactAlgorithm();
    if (wish.make || wish.key.pixels.isEmpty() || options.ghosting || options.leastLength > 0
        || !isMaskable(wish.key.region))
        return false;
    if (!areThin(wish.lines, wish.document.styles(), options, wish.key.pixelRatio))
        return false;
    if (same || options.removed == RemovedPart::Shown)
        return true;
    constexpr double visible = 1.0 / 16; // device pixels
    const auto clipAll = clipping::exactAlgorithm().corrected.clipAll;
    return areSame(frame, exact_.clip(wish.lines, wish.key.region, clipAll, stop),
                   visible / (wish.key.view.zoom * wish.key.pixelRatio));
}

ComposedFrame::DrawingKey ComposedFrame::drawingKeyOf(const FrameWish& wish)
{
    const FrameKey& key = wish.key;
    return {
        {.lines = key.lines, .view = key.view, .pixels = key.pixels, .pixelRatio = key.pixelRatio},
        wish.options.page,
        wish.options.leastWidth,
        wish.options.strokes};
}

QImage ComposedFrame::paint(const FrameWish& wish, const SceneFrame& frame,
                            const Follower& follower, const std::shared_ptr<FrameParts>& parts,
                            QThreadPool& helpers)
{
    PictureOptions options = wish.pictureOptions();
    options.stop = follower.stop;
    const StyleTable& styles = wish.document.styles();
    const DrawingKey key = drawingKeyOf(wish);
    const bool isKnown = !drawing_.isNull() && key_ == key;
    QImage drawing =
        isKnown ? drawing_ : QImage(wish.key.pixels, QImage::Format_ARGB32_Premultiplied);
    uchar* const pixels = isKnown ? nullptr : drawing.bits();
    const double ghost = options.removed == RemovedPart::Shown    ? 1
                         : options.removed == RemovedPart::Hidden ? 0
                                                                  : wish.ghost;
    QImage mask = regionMask(wish.key.region, wish.key.view, wish.key.pixels, wish.key.pixelRatio);
    openAlong(mask, linesAlongEdges(styles, wish.lines, frame, options, wish.key.pixelRatio),
              wish.key.pixelRatio);
    Picture all, around = pictureAround(styles, wish.lines, options);
    const bool isAlone = around.selected.commands.empty() && around.differing.commands.empty()
                         && around.borders.commands.empty();
    if (!isKnown)
        all.kept = wholeDrawing(styles, wish.lines, frame, options);
    auto paint = [drawing, pixels, ghost, raster = wish.rasterOptions(follower.stop),
                  all = std::move(all), around = std::move(around), isAlone,
                  mask = std::move(mask)](Band band) {
        if (pixels) { // each thread writes rows of its own
            const QImage drawn = rasterised(all, band, raster);
            std::memcpy(pixels + band.top * drawing.bytesPerLine(), drawn.constBits(),
                        std::size_t(drawn.sizeInBytes()));
        }
        const QImage shown = composed(drawing, mask, band, ghost);
        return isAlone ? shown : rasterised(around, band, raster, shown);
    };
    const bool slow = !isKnown && wish.lines.size() > slowLines;
    const QImage image =
        paintedInBands(std::move(paint), wish.key.pixels.height(), slow, follower, parts, helpers);
    if (!follower.stop.stop_requested())
        drawing_ = drawing, key_ = key;
    return image;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/composed_frame.h"

#include "app/scene/kept_box.h"
#include "app/view/edge_lines.h"
#include "app/view/frame_times.h"
#include "app/view/hairline_drawing.h"
#include "app/view/missing_part.h"
#include "app/view/region_mask.h"

#include <algorithm>

namespace app {
namespace {

/// Whether the strokes are so thin, in device pixels, that a straight cut looks like that of a
/// mask.
bool areThin(const SceneLines& lines, const StyleTable& styles, const PictureOptions& options,
             double pixelRatio)
{
    constexpr double thin = 1.5;
    std::optional<StyleIndex> last;
    for (const auto& block : lines.blocks())
        for (const SceneChunk& chunk : block->chunks) {
            if (last == chunk.style)
                continue;
            const Style& style = styles[*(last = chunk.style)];
            if (style.stroke
                && (strokeWidth(style, options) * pixelRatio > thin
                    || (style.fill && options.closesAreas)))
                return false;
        }
    return true;
}

/// The opacity of what the windows remove.
double opacityOf(RemovedPart removed, double ghost)
{
    return removed == RemovedPart::Shown ? 1 : removed == RemovedPart::Hidden ? 0 : ghost;
}

/// Paints the bands of a frame. Any thread may use it.
struct ComposedBands {
    FrameWish wish; ///< owns what is painted
    RasterOptions raster;
    QImage drawing;                   ///< all lines
    uchar* pixels;                    ///< of `drawing`
    std::vector<MissingPart> missing; ///< of `drawing`, to be painted first
    Picture around{};                 ///< what lies below and above the lines
    QImage mask;
    DifferingLayer differing;

    QImage operator()(Band band, QImage shown) const
    {
        for (const MissingPart& part : missing)
            paintPart(part, band, wish, raster, pixels);
        compose(rowsOf(drawing, band), rowsOf(mask, band), raster.ghost, shown);
        if (!differing.isEmpty())
            paintAnew(shown, differing, band, raster);
        return rasterised(around, band, raster, shown);
    }
};

} // namespace

/// The lines that the frame's row cuts differently from `exact`.
ComposedFrame::Plan ComposedFrame::compared(const FrameWish& wish, const SceneFrame& frame,
                                            const std::stop_token& stop)
{
    if (wish.options.removed == RemovedPart::Shown
        || wish.key.variant.algorithm == &clipping::exactAlgorithm())
        return {};
    constexpr double visible = 1.0 / 16; // device pixels
    const auto clipAll = clipping::exactAlgorithm().corrected.clipAll;
    Plan plan{.exact = exact_.clip(wish.lines, wish.key.region, clipAll, stop)};
    if (stop.stop_requested())
        return plan;
    plan.differing = differingLines(
        frame, plan.exact, visible / (wish.key.view.zoom * wish.key.pixelRatio), mostDiffering);
    return plan;
}

ComposedFrame::Plan ComposedFrame::plan(const FrameWish& wish, const SceneFrame& frame,
                                        const std::stop_token& stop)
{
    Plan plan = compared(wish, frame, stop);
    const PictureOptions options = wish.pictureOptions();
    if (!wish.isImage() || options.ghosting || options.leastLength > 0
        || !isMaskable(wish.key.region))
        return plan;
    // Images are cut at the rectangle around the windows, not at a mask.
    if (!wish.underlays.empty()
        && (!plan.differing.empty()
            || !std::ranges::all_of(wish.underlays, [&](const SeenUnderlay& seen) {
                   return isCutExactly(*seen.underlay, wish.key.region);
               })))
        return plan;
    const bool isRoughAllowed = wish.rough && wish.isLarge();
    const bool isTrue =
        plan.differing.empty()
        && areThin(wish.lines, wish.document.styles(), options, wish.key.pixelRatio);
    if (isTrue)
        plan.kind = Plan::Kind::Truly;
    else if (isRoughAllowed && plan.differing.size() <= mostDiffering)
        plan.kind = Plan::Kind::Roughly;
    return plan;
}

QImage ComposedFrame::paint(const FrameWish& wish, const SceneFrame& frame, const Plan& plan,
                            const Follower& follower, const std::shared_ptr<FrameParts>& parts)
{
    PictureOptions options = wish.pictureOptions();
    options.stop = follower.stop;
    const StyleTable& styles = wish.document.styles();
    const double ratio = wish.key.pixelRatio;
    const DrawingKey key = drawingKeyOf(wish);
    DrawingPictures& kept = wish.drawings ? *wish.drawings : own_;
    auto [drawing, missing] = kept.find(key);
    const bool isKnown = missing.empty(), isNew = missing == std::vector{drawing.rect()};
    const bool hairlines =
        !isKnown && wish.underlays.empty() && hasOnlyHairlines(wish.lines, styles, options, ratio);
    uchar* const pixels = isKnown ? nullptr : drawing.bits(); // detaches it before it is shared
    QImage mask = regionMask(wish.key.region, wish.key.view, wish.key.pixels, ratio);
    openAlong(mask, linesAlongEdges(styles, wish.lines, frame, options, ratio), ratio);
    RasterOptions raster = wish.rasterOptions(follower.stop);
    raster.ghost = opacityOf(options.removed, wish.ghost);
    const ComposedBands bands{
        .wish = wish,
        .raster = raster,
        .drawing = drawing,
        .pixels = pixels,
        .missing = missingParts(wish, frame, missing, hairlines, follower.stop),
        .around = pictureAround(styles, wish.lines, options),
        .mask = std::move(mask),
        .differing =
            differingLayer(styles, wish.lines, frame, plan.exact, plan.differing, options)};
    const int slow = hairlines ? fewEarly : seenEarly;
    const bool isSlow = isNew && wish.isLarge();
    const QImage image =
        paintedInBands(std::cref(bands), wish.key.pixels, isSlow ? slow : 1, follower, *parts);
    if (!isKnown && !follower.stop.stop_requested())
        kept.keep(key, drawing);
    return image;
}

} // namespace app

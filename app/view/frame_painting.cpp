// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_painting.h"

#include "app/view/hairline_drawing.h"

#include <QElapsedTimer>
#include <QPainter>

namespace app {

SceneFrame FramePainter::clipped(const FrameWish& wish, const std::stop_token& stop)
{
    const auto* uses = clipping::functionsOf(*wish.key.variant.algorithm, wish.key.variant.form);
    return clipping_.clip(wish.lines, wish.key.region, uses->clipAll, stop);
}

static ClipResult resultOf(const SceneFrame& frame)
{
    return {frame.nanoseconds, frame.visible, frame.total};
}

ClipResult FramePainter::clip(const FrameWish& wish, const std::stop_token& stop)
{
    return resultOf(clipped(wish, stop));
}

constexpr std::size_t manyPoints = 50'000; // painted in more bands than there are threads

/// Paints what is left of the lines of a drawing of separate hairlines.
static PaintBand hairlinesPainted(const FrameWish& wish, const SceneFrame& frame,
                                  const PictureOptions& options, const RasterOptions& raster)
{
    return [&, around = pictureAround(wish.document.styles(), wish.lines, options)](Band band,
                                                                                    QImage image) {
        const auto paint = [&](Painted which) {
            paintHairlines(image, wish.lines, {frame, which}, wish.document.styles(), options, band,
                           raster);
        };
        image.fill(Qt::transparent);
        if (options.removed == RemovedPart::Ghosted) {
            paint(Painted::Removed);
            QPainter painter(&image);
            painter.setCompositionMode(QPainter::CompositionMode_DestinationIn);
            painter.fillRect(image.rect(), QColor::fromRgbF(0, 0, 0, float(raster.ghost)));
        }
        paint(options.removed == RemovedPart::Shown ? Painted::All : Painted::Kept);
        return rasterised(around, band, raster, image);
    };
}

/// Paints a frame from the pieces that are left of its lines.
static PaintedFrame framePainted(const FrameWish& wish, const SceneFrame& frame,
                                 const Follower& follower, const std::shared_ptr<FrameParts>& parts)
{
    PictureOptions options = wish.pictureOptions();
    options.stop = follower.stop;
    const RasterOptions raster = wish.rasterOptions(follower.stop);
    PaintedFrame made;
    if (wish.isImage() && options.leastLength == 0 && !options.ghosting && wish.underlays.empty()
        && hasOnlyHairlines(wish.lines, wish.document.styles(), options, wish.key.pixelRatio)) {
        const PaintBand paint = hairlinesPainted(wish, frame, options, raster);
        const int bands = wish.isLarge() ? fewEarly : 1;
        made.image = paintedInBands(paint, wish.key.pixels, bands, follower, *parts);
        return made;
    }
    const Picture shown = picture(wish.document.styles(), wish.lines, frame, options);
    if (wish.isMade() && !follower.stop.stop_requested())
        made.made = wish.make(shown);
    if (!wish.isImage() || follower.stop.stop_requested())
        return made;
    const bool slow = shown.kept.points.size() + shown.ghost.points.size() > manyPoints;
    const auto paint = [&](Band band, const QImage&) { return rasterised(shown, band, raster); };
    made.image = paintedInBands(paint, wish.key.pixels, slow ? seenEarly : 1, follower, *parts);
    return made;
}

PaintedFrame FramePainter::paint(const FrameWish& wish, const Follower& follower,
                                 const std::shared_ptr<FrameParts>& parts)
{
    const SceneFrame frame = clipped(wish, follower.stop);
    if (follower.stop.stop_requested())
        return {};
    parts->put(resultOf(frame));
    follower.progress({});
    QElapsedTimer clock;
    clock.start();
    PaintedFrame made;
    const auto plan = composed_.plan(wish, frame, follower.stop);
    if (plan.kind != ComposedFrame::Plan::Kind::No)
        made.image = composed_.paint(wish, frame, plan, follower, parts);
    else
        made = framePainted(wish, frame, follower, parts);
    made.rough = plan.kind == ComposedFrame::Plan::Kind::Roughly;
    made.differing = plan.differing.size();
    made.drawMs = double(clock.nsecsElapsed()) * 1e-6;
    return made;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_painting.h"

#include "app/scene/same_frames.h"
#include "app/view/composed.h"
#include "app/view/edge_lines.h"
#include "app/view/region_mask.h"

#include <QElapsedTimer>
#include <QThreadPool>

#include <atomic>
#include <cstring>
#include <functional>
#include <latch>

namespace app {
namespace {

// A picture with more points is painted in more bands than there are threads: they are shown as
// soon as they are finished.
constexpr std::size_t manyPoints = 50'000;
constexpr int bandsOfEachThread = 8;

/// The bands of an image, painted by any number of threads, which share its ownership.
class BandPainting {
public:
    /// Paints a band; several threads call it at the same time.
    using Paint = std::function<QImage(Band)>;

    BandPainting(Paint paint, int height, const std::stop_token& stop, int bands)
        : paint_(std::move(paint)), stop_(stop), bands_(bandsOf(height, bands)),
          images_(bands_.size()), left_(std::ptrdiff_t(bands_.size()))
    {
    }

    /// Paints the bands that no other thread has begun, and calls `finished` after each.
    template <class Finished>
    void work(const Finished& finished)
    {
        for (std::size_t i = next_++; i < bands_.size(); i = next_++) {
            images_[i] = paint_(bands_[i]);
            if (!stop_.stop_requested())
                finished(FinishedBand{bands_[i], images_[i]});
            left_.count_down();
        }
    }
    /// All of it, after the other threads have finished their bands.
    QImage image() const
    {
        left_.wait();
        return joined(images_);
    }

private:
    const Paint paint_;
    const std::stop_token stop_;
    const std::vector<Band> bands_;
    std::vector<QImage> images_;
    std::atomic<std::size_t> next_ = 0;
    std::latch left_;
};

RasterOptions rasterOptions(const FrameWish& wish, const std::stop_token& stop)
{
    return {wish.key.pixels.width(), wish.key.pixelRatio, wish.ghost,
            [stop] { return stop.stop_requested(); }};
}

/// Whether the strokes are so thin, in device pixels, that a straight cut looks like that of a
/// mask.
bool areThin(const SceneLines& lines, const StyleTable& styles, const PictureOptions& options,
             double pixelRatio)
{
    constexpr double thin = 1.5;
    const double most = thin / (options.view.zoom * pixelRatio * options.strokes);
    const bool closesAreas = options.closesAreas;
    std::optional<StyleIndex> last;
    for (const auto& block : lines.blocks())
        for (const SceneChunk& chunk : block->chunks) {
            if (last == chunk.style)
                continue;
            const Style& style = styles[*(last = chunk.style)];
            if (style.stroke && (style.width > most || (style.fill && closesAreas)))
                return false;
        }
    return options.leastWidth * options.strokes * pixelRatio <= thin;
}

} // namespace

void FrameParts::put(const ClipResult& clipped)
{
    const std::scoped_lock lock(lock_);
    clipped_ = clipped;
}

void FrameParts::put(const FinishedBand& band)
{
    const std::scoped_lock lock(lock_);
    bands_.push_back(band);
}

std::optional<ClipResult> FrameParts::clipped() const
{
    const std::scoped_lock lock(lock_);
    return clipped_;
}

std::vector<FinishedBand> FrameParts::bands() const
{
    const std::scoped_lock lock(lock_);
    return bands_;
}

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

/// Whether the frame can be put together from the picture of all lines: where the row's pieces are
/// those of `exact`, as far as can be seen.
bool FramePainter::composes(const FrameWish& wish, const SceneFrame& frame,
                            const std::stop_token& stop)
{
    const PictureOptions& options = wish.options;
    const bool same = wish.key.variant.algorithm == &clipping::exactAlgorithm();
    if (wish.make || wish.key.pixels.isEmpty() || options.ghosting || options.leastLength > 0
        || !isMaskable(wish.key.region))
        return false;
    PictureOptions seen = options;
    seen.view = wish.key.view;
    if (!areThin(wish.lines, wish.document.styles(), seen, wish.key.pixelRatio))
        return false;
    if (same || options.removed == RemovedPart::Shown)
        return true;
    constexpr double visible = 1.0 / 16; // device pixels
    const auto clipAll = clipping::exactAlgorithm().corrected.clipAll;
    return areSame(frame, exact_.clip(wish.lines, wish.key.region, clipAll, stop),
                   visible / (wish.key.view.zoom * wish.key.pixelRatio));
}

static QImage painted(BandPainting::Paint paint, bool slow, const FrameWish& wish,
                      const Follower& follower, const std::shared_ptr<FrameParts>& parts,
                      QThreadPool& helpers)
{
    const int threads = helpers.maxThreadCount();
    const auto bands =
        std::make_shared<BandPainting>(std::move(paint), wish.key.pixels.height(), follower.stop,
                                       slow ? threads * bandsOfEachThread : threads);
    for (int i = 1; i < threads; ++i)
        helpers.start(
            [bands, parts] { bands->work([&](const FinishedBand& band) { parts->put(band); }); });
    bands->work([&](const FinishedBand& band) {
        parts->put(band);
        follower.progress({});
    });
    return bands->image();
}

FramePainter::DrawingKey FramePainter::drawingKeyOf(const FrameWish& wish)
{
    const FrameKey& key = wish.key;
    return {
        {.lines = key.lines, .view = key.view, .pixels = key.pixels, .pixelRatio = key.pixelRatio},
        wish.options.page,
        wish.options.leastWidth,
        wish.options.strokes};
}

/// Puts a frame together from the picture of all lines, which is painted first if it is another
/// drawing or view than before.
QImage FramePainter::composedFrame(const FrameWish& wish, const SceneFrame& frame,
                                   const Follower& follower,
                                   const std::shared_ptr<FrameParts>& parts, QThreadPool& helpers)
{
    PictureOptions options = wish.pictureOptions();
    options.stop = follower.stop;
    const StyleTable& styles = wish.document.styles();
    const DrawingKey key = drawingKeyOf(wish);
    const bool isKnown = !drawing_.isNull() && drawingKey_ == key;
    QImage drawing =
        isKnown ? drawing_ : QImage(wish.key.pixels, QImage::Format_ARGB32_Premultiplied);
    uchar* const pixels = isKnown ? nullptr : drawing.bits();
    const double ghost = options.removed == RemovedPart::Shown    ? 1
                         : options.removed == RemovedPart::Hidden ? 0
                                                                  : wish.ghost;
    QImage mask = regionMask(wish.key.region, wish.key.view, wish.key.pixels, wish.key.pixelRatio);
    openAlong(mask, linesAlongEdges(styles, wish.lines, frame, options, wish.key.pixelRatio),
              wish.key.pixelRatio);
    Picture all;
    if (!isKnown)
        all.kept = wholeDrawing(styles, wish.lines, frame, options);
    auto paint = [drawing, pixels, ghost, raster = rasterOptions(wish, follower.stop),
                  all = std::move(all), around = pictureAround(styles, wish.lines, options),
                  mask = std::move(mask)](Band band) {
        if (pixels) { // each thread writes rows of its own
            const QImage drawn = rasterised(all, band, raster);
            std::memcpy(pixels + band.top * drawing.bytesPerLine(), drawn.constBits(),
                        std::size_t(drawn.sizeInBytes()));
        }
        return rasterised(around, band, raster, composed(drawing, mask, band, ghost));
    };
    const bool slow = !isKnown && wish.lines.size() > manyPoints / 2;
    const QImage image = painted(std::move(paint), slow, wish, follower, parts, helpers);
    if (!follower.stop.stop_requested())
        drawing_ = drawing, drawingKey_ = key;
    return image;
}

/// Paints a frame from the pieces that are left of its lines.
static PaintedFrame framePainted(const FrameWish& wish, const SceneFrame& frame,
                                 const Follower& follower, const std::shared_ptr<FrameParts>& parts,
                                 QThreadPool& helpers)
{
    PictureOptions options = wish.pictureOptions();
    options.stop = follower.stop;
    Picture shown = picture(wish.document.styles(), wish.lines, frame, options);
    PaintedFrame made;
    if (wish.make && !follower.stop.stop_requested())
        made.made = wish.make(shown);
    if (wish.key.pixels.isEmpty() || follower.stop.stop_requested())
        return made;
    const bool slow = shown.kept.points.size() + shown.ghost.points.size() > manyPoints;
    auto paint = [shown = std::move(shown), raster = rasterOptions(wish, follower.stop)](
                     Band band) { return rasterised(shown, band, raster); };
    made.image = painted(std::move(paint), slow, wish, follower, parts, helpers);
    return made;
}

PaintedFrame FramePainter::paint(const FrameWish& wish, const Follower& follower,
                                 const std::shared_ptr<FrameParts>& parts, QThreadPool& helpers)
{
    const SceneFrame frame = clipped(wish, follower.stop);
    if (follower.stop.stop_requested())
        return {};
    parts->put(resultOf(frame));
    follower.progress({});
    QElapsedTimer clock;
    clock.start();
    PaintedFrame made;
    if (composes(wish, frame, follower.stop))
        made.image = composedFrame(wish, frame, follower, parts, helpers);
    else
        made = framePainted(wish, frame, follower, parts, helpers);
    made.drawMs = double(clock.nsecsElapsed()) * 1e-6;
    return made;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_painting.h"

#include <QElapsedTimer>
#include <QThreadPool>

#include <atomic>
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
    BandPainting(Picture picture, const FrameWish& wish, const std::stop_token& stop, int threads)
        : picture_(std::move(picture)), options_{wish.key.pixels.width(), wish.key.pixelRatio,
                                                 wish.ghost,
                                                 [stop] { return stop.stop_requested(); }},
          bands_(bandsOf(wish.key.pixels.height(), threads)), images_(bands_.size()),
          left_(std::ptrdiff_t(bands_.size()))
    {
    }

    /// Paints the bands that no other thread has begun, and calls `finished` after each.
    template <class Finished>
    void work(const Finished& finished)
    {
        for (std::size_t i = next_++; i < bands_.size(); i = next_++) {
            images_[i] = rasterised(picture_, bands_[i], options_);
            if (!options_.cancelled())
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
    const Picture picture_;
    const RasterOptions options_;
    const std::vector<Band> bands_;
    std::vector<QImage> images_;
    std::atomic<std::size_t> next_ = 0;
    std::latch left_;
};

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

static QImage painted(Picture picture, const FrameWish& wish, const Follower& follower,
                      const std::shared_ptr<FrameParts>& parts, QThreadPool& helpers)
{
    const int threads = helpers.maxThreadCount();
    const bool slow = picture.kept.points.size() + picture.ghost.points.size() > manyPoints;
    const auto bands = std::make_shared<BandPainting>(std::move(picture), wish, follower.stop,
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
    PictureOptions options = wish.pictureOptions();
    options.stop = follower.stop;
    Picture shown = picture(wish.document.styles(), wish.lines, frame, options);
    PaintedFrame made;
    if (wish.make && !follower.stop.stop_requested())
        made.made = wish.make(shown);
    if (!wish.key.pixels.isEmpty() && !follower.stop.stop_requested())
        made.image = painted(std::move(shown), wish, follower, parts, helpers);
    made.drawMs = double(clock.nsecsElapsed()) * 1e-6;
    return made;
}

} // namespace app

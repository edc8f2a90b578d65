// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/band_painting.h"

#include <QThreadPool>

#include <atomic>
#include <latch>

namespace app {

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

namespace {

/// The bands of an image, painted by any number of threads, which share its ownership.
class BandPainting {
public:
    BandPainting(PaintBand paint, int height, const std::stop_token& stop, int bands)
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
    const PaintBand paint_;
    const std::stop_token stop_;
    const std::vector<Band> bands_;
    std::vector<QImage> images_;
    std::atomic<std::size_t> next_ = 0;
    std::latch left_;
};

} // namespace

QImage paintedInBands(PaintBand paint, int height, int each, const Follower& follower,
                      const std::shared_ptr<FrameParts>& parts, QThreadPool& helpers)
{
    const int threads = helpers.maxThreadCount();
    const auto bands =
        std::make_shared<BandPainting>(std::move(paint), height, follower.stop, threads * each);
    for (int i = 1; i < threads; ++i)
        helpers.start(
            [bands, parts] { bands->work([&](const FinishedBand& band) { parts->put(band); }); });
    bands->work([&](const FinishedBand& band) {
        parts->put(band);
        follower.progress({});
    });
    return bands->image();
}

} // namespace app

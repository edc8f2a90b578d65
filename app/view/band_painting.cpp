// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/band_painting.h"

#include "app/base/in_parallel.h"

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

QImage paintedInBands(const PaintBand& paint, int height, int each, const Follower& follower,
                      FrameParts& parts, QThreadPool& helpers)
{
    const auto bands = bandsOf(height, int(workersOf(helpers)) * each);
    std::vector<QImage> images(bands.size());
    inParallel(helpers, bands.size(), [&](std::size_t i, std::size_t worker) {
        images[i] = paint(bands[i]);
        if (follower.stop.stop_requested())
            return;
        parts.put(FinishedBand{bands[i], images[i]});
        if (worker == 0)
            follower.progress({});
    });
    return joined(images);
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/band_painting.h"

#include "app/base/background.h"
#include "app/base/in_parallel.h"

#include <cstring>
#include <new>

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

static QImage rowsOf(const QImage& image, Band band, uchar* pixels)
{
    return {pixels + band.top * image.bytesPerLine(),
            image.width(),
            band.height,
            image.bytesPerLine(),
            image.format(),
            [](void* whole) { delete static_cast<QImage*>(whole); },
            new QImage(image)};
}

QImage rowsOf(const QImage& image, Band band)
{
    return rowsOf(image, band, const_cast<uchar*>(image.constBits()));
}

QImage paintedInBands(const PaintBand& paint, const QSize& pixels, int each,
                      const Follower& follower, FrameParts& parts)
{
    QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
    if (image.isNull() && !pixels.isEmpty())
        throw std::bad_alloc();
    uchar* const bits = image.bits();
    const auto bands = bandsOf(pixels.height(), int(workersOf(paintingThreads())) * each);
    const std::size_t workers = workersOf(paintingThreads());
    inParallel(paintingThreads(), workers, bands.size(), [&](std::size_t i, std::size_t worker) {
        QImage room = rowsOf(image, bands[i], bits);
        const uchar* const there = room.constBits();
        const QImage painted = paint(bands[i], std::move(room));
        if (follower.stop.stop_requested())
            return;
        if (painted.constBits() != there)
            std::memcpy(const_cast<uchar*>(there), painted.constBits(),
                        std::size_t(painted.sizeInBytes()));
        parts.put(FinishedBand{bands[i], painted});
        if (worker == 0)
            follower.progress({});
    });
    return image;
}

} // namespace app

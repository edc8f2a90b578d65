// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/progress.h"
#include "app/view/raster.h"

#include <functional>
#include <mutex>
#include <optional>
#include <vector>

namespace app {

/// The result of clipping all lines.
struct ClipResult {
    std::uint64_t nanoseconds = 0; ///< of processor time
    std::size_t visible = 0, total = 0;
};

/// A finished band of an image.
struct FinishedBand {
    Band band;
    QImage image;
};

/// The finished parts of a frame. The threads that work on it share it and add to it; others
/// read it.
class FrameParts {
public:
    void put(const ClipResult& clipped);
    void put(const FinishedBand& band);
    std::optional<ClipResult> clipped() const;
    std::vector<FinishedBand> bands() const;

private:
    mutable std::mutex lock_;
    std::optional<ClipResult> clipped_;
    std::vector<FinishedBand> bands_;
};

/// Some rows of an image, without a copy of them; they keep it alive. Who paints on them paints on
/// it, if no other image shares its pixels.
QImage rowsOf(const QImage& image, Band band);

/// Paints a band; several threads call it at the same time. `room` has the band's place in the
/// image and no content: a band that is painted there need not be copied.
using PaintBand = std::function<QImage(Band band, QImage room)>;

constexpr int seenEarly = 8; ///< bands of each thread for what takes long
constexpr int fewEarly = 2;  ///< the same if each band goes through all lines

/// An image, painted in bands by the calling thread and by painting threads that are free.
/// Each band is put into `parts` as soon as it is finished. `each` is the number of bands for each
/// thread: of several the first are seen early, but what every band goes through takes longer. If a
/// stop is requested, the result is of no use.
QImage paintedInBands(const PaintBand& paint, const QSize& pixels, int each,
                      const Follower& follower, FrameParts& parts);

} // namespace app

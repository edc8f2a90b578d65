// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/raster.h"

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

} // namespace app

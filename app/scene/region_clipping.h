// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/stopwatch.h"
#include "app/scene/region.h"
#include "clipping/algorithm.h"

namespace app {

/// The type of `clipping::Uses::clipAll`. Pieces with numbers that are not finite are dropped by
/// the fold.
using ClipAll = decltype(clipping::Uses<clipping::Segment, clipping::Window>::clipAll);

/// Clips lines with one algorithm at each window of a region. Reuses its buffers.
class RegionClipping {
public:
    void start(const ClipRegion& region,
               ClipAll clipAll); ///< `region` must live until the next start
    /// For a region of a single window. Writes the kept pieces of the lines, in order, to the
    /// beginning of `out` and returns their number. `first` is added to each source. The pieces are
    /// the results of `clipAll`, or of `outsideAll` for them. Requires `out.size() >= 2 *
    /// lines.size()`.
    std::size_t clip(std::span<const clipping::Segment> lines, std::size_t first,
                     std::span<clipping::Clipped> out);
    /// Appends the pieces that the region keeps of each line. It must have a window. At windows
    /// that are not all axis-aligned rectangles the lines are clipped with exact decisions,
    /// whatever the algorithm is.
    void fold(std::span<const clipping::Segment> lines, std::size_t first,
              std::vector<clipping::Clipped>& kept);
    /// The time that the algorithm has used since `start`, without the time for combining pieces.
    std::uint64_t nanoseconds() const { return stopwatch_.nanoseconds(); }

private:
    using Pieces = std::span<clipping::Clipped>;

    std::size_t clipAt(const clipping::Window& window, std::span<const clipping::Segment> lines,
                       const Pieces& out);
    void clipAtAll(std::span<const clipping::Segment> lines);
    void clipPrepared(std::span<const clipping::Segment> lines, std::size_t first,
                      std::vector<clipping::Clipped>& kept);

    const ClipRegion* region_ = nullptr;
    ClipAll clipAll_ = nullptr;
    Stopwatch stopwatch_;
    std::vector<clipping::Clipped> buffer_;
    std::vector<Pieces> left_; ///< for each step, the pieces of lines that are not folded yet
    std::vector<std::optional<clipping::Clipped>> atStep_; ///< for one line
    std::vector<clipping::RegionPiece> shaped_;
};

} // namespace app

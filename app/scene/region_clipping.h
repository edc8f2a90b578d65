// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/stopwatch.h"
#include "app/scene/region.h"
#include "clipping/algorithm.h"

namespace app {

/// As in `clipping::Uses`; pieces have finite numbers or are dropped where they are folded.
using ClipAll = decltype(clipping::Uses<clipping::Segment, clipping::Window>::clipAll);

/// Clips lines by one algorithm, each of them at each window of a region. Keeps its buffers.
class RegionClipping {
public:
    void start(const ClipRegion& region,
               ClipAll clipAll); ///< `region` is used until the next start
    /// Writes what is kept of each of the lines, in their order, to the beginning of `out`, and
    /// says how many pieces there are. `first` is added to each source. The region is a single
    /// window: the pieces are what `clipAll`, or `outsideAll` of it, gives. `out.size() >= 2 *
    /// lines.size()`.
    std::size_t clip(std::span<const clipping::Segment> lines, std::size_t first,
                     std::span<clipping::Clipped> out);
    /// Appends what `fold` keeps of each of the lines. There must be a window.
    void fold(std::span<const clipping::Segment> lines, std::size_t first,
              std::vector<clipping::Clipped>& kept);
    /// That the algorithm has needed since `start`. To put pieces together is not its work.
    std::uint64_t nanoseconds() const { return stopwatch_.nanoseconds(); }

private:
    using Pieces = std::span<clipping::Clipped>;

    std::size_t clipAt(const clipping::Window& window, std::span<const clipping::Segment> lines,
                       const Pieces& out);
    void clipAtAll(std::span<const clipping::Segment> lines);

    const ClipRegion* region_ = nullptr;
    ClipAll clipAll_ = nullptr;
    Stopwatch stopwatch_;
    std::vector<clipping::Clipped> buffer_;
    std::vector<Pieces> left_; ///< of each step, those of lines that are not folded yet
    std::vector<std::optional<clipping::Clipped>> atStep_; ///< of one line
};

} // namespace app

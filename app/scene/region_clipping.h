// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/clock.h"
#include "app/scene/step_clipping.h"

#include <stop_token>

namespace app {

/// Clips lines with one algorithm at the windows of a region: all of them at once if the algorithm
/// has a form for regions, otherwise at each of them. If it cannot clip at one of the windows,
/// another one does (`usedAt`). Reuses its buffers.
class RegionClipping {
public:
    /// `region` must live until the next start. `clipAll` is that of the chosen form. When a stop
    /// is requested, pieces are missing from then on.
    void start(const ClipRegion& region, ClipAll clipAll, const std::stop_token& stop = {});
    /// Starts with what another one was started with, without preparing the region again.
    void startAs(const RegionClipping& other);
    /// Whether `clip` may be called: a single window is clipped at, without its neighbours.
    bool atOneWindow() const { return started_.oneWindow; }
    /// Whether the row `exact` clips, whatever was chosen.
    bool isExact() const { return started_.forms.exact; }
    /// Writes the kept pieces of the lines, in order, to the beginning of `out` and returns their
    /// number. `first` is added to each source. The pieces are the results of the algorithm, or of
    /// `outsideAll` for them; a published form may return anything. Requires `out.size() >= 2 *
    /// lines.size()`.
    std::size_t clip(std::span<const clipping::Segment> lines, std::size_t first,
                     std::span<clipping::Clipped> out);
    /// Appends the pieces that the region keeps of each line. It must have a window. Pieces with
    /// numbers that are not finite are dropped.
    void fold(std::span<const clipping::Segment> lines, std::size_t first,
              std::vector<clipping::Clipped>& kept);
    /// The processor time that the algorithm has used since `start`, without combining pieces.
    std::uint64_t nanoseconds() const { return stopwatch_.nanoseconds(); }

private:
    using Pieces = std::span<clipping::Clipped>;

    std::size_t clipAt(const ClipRegion::Step& step, std::span<const clipping::Segment> lines,
                       const Pieces& out);
    void clipAtAll(std::span<const clipping::Segment> lines);
    void clipRegion(std::span<const clipping::Segment> lines, std::size_t first,
                    std::vector<clipping::Clipped>& kept);

    struct Started {
        const ClipRegion* region = nullptr;
        std::stop_token stop{};
        RowForms forms{};
        /// If the form for regions is used.
        std::shared_ptr<const clipping::PreparedRegion> prepared{};
        bool oneWindow = false;
        bool keepsInside = true; ///< of the one window
    };

    Started started_;
    Stopwatch stopwatch_;
    std::vector<clipping::Clipped> buffer_;
    std::vector<Pieces> left_; ///< for each step, the pieces of lines that are not folded yet
    std::vector<std::optional<clipping::Clipped>> atStep_; ///< for one line
    std::vector<clipping::RegionPiece> shaped_;
};

} // namespace app

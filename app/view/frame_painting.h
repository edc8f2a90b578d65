// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/progress.h"
#include "app/scene/scene_clipping.h"
#include "app/view/frame_wish.h"
#include "app/view/raster.h"

#include <mutex>

class QThreadPool;

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

/// What is finished of a frame so far. The threads that work on it share it and add to it; others
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

/// A finished frame: its image, or what FrameWish::make has made.
struct PaintedFrame {
    QImage image{};
    std::shared_ptr<const void> made{};
    double drawMs = 0; ///< building the picture and painting it
};

/// Clips and paints frames, one at a time, on any thread. Keeps its buffers from one to the next,
/// and the picture of all lines: while only the clip windows move, frames are put together from it
/// (composed.h).
class FramePainter {
public:
    /// If a stop is requested, the result is of no use.
    ClipResult clip(const FrameWish& wish, const std::stop_token& stop);
    /// The bands of the image are painted by the calling thread, and by those of `helpers` that are
    /// free. Reports progress with each finished part. If a stop is requested, it returns within
    /// some milliseconds, and the result is of no use.
    PaintedFrame paint(const FrameWish& wish, const Follower& follower,
                       const std::shared_ptr<FrameParts>& parts, QThreadPool& helpers);

private:
    SceneFrame clipped(const FrameWish& wish, const std::stop_token& stop);
    bool composes(const FrameWish& wish, const SceneFrame& frame, const std::stop_token& stop);
    QImage composedFrame(const FrameWish& wish, const SceneFrame& frame, const Follower& follower,
                         const std::shared_ptr<FrameParts>& parts, QThreadPool& helpers);

    SceneClipping clipping_, exact_;
    /// What the picture of all lines depends on.
    struct DrawingKey {
        FrameKey frame; ///< lines, view and pixels alone
        std::optional<Colour> page{};
        double leastWidth = 0, strokes = 0;
        friend bool operator==(const DrawingKey&, const DrawingKey&) = default;
    };
    static DrawingKey drawingKeyOf(const FrameWish& wish);
    DrawingKey drawingKey_;
    QImage drawing_; ///< all lines in the view, whatever the windows remove; may be null
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/composed_frame.h"

namespace app {

/// A finished frame: its image, or what FrameWish::make has made.
struct PaintedFrame {
    QImage image{};
    std::shared_ptr<const void> made{};
    double drawMs = 0;         ///< building the picture and painting it
    bool rough = false;        ///< to be painted again without FrameWish::rough
    std::size_t differing = 0; ///< FrameTimes::differing
};

/// Clips and paints frames, one at a time, on any thread. Keeps its buffers from one to the next.
class FramePainter {
public:
    /// If a stop is requested, the result is of no use.
    ClipResult clip(const FrameWish& wish, const std::stop_token& stop);
    /// The bands of the image are painted by the calling thread, and by painting threads that are
    /// free. Reports progress with each finished part. If a stop is requested, it returns within
    /// some milliseconds, and the result is of no use.
    PaintedFrame paint(const FrameWish& wish, const Follower& follower,
                       const std::shared_ptr<FrameParts>& parts);

private:
    SceneFrame clipped(const FrameWish& wish, const std::stop_token& stop);

    SceneClipping clipping_;
    ComposedFrame composed_;
};

} // namespace app

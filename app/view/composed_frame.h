// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_clipping.h"
#include "app/view/band_painting.h"
#include "app/view/differing_layer.h"
#include "app/view/drawing_pictures.h"

namespace app {

/// Frames that are put together from the picture of all lines, which does not depend on the clip
/// windows and is kept: inside them as it is, outside with the ghost's opacity. So a window that
/// moves changes a mask (region_mask.h) and, above it, the lines that its row cuts differently from
/// `exact` (differing_layer.h).
class ComposedFrame {
public:
    /// A frame put together, or why it cannot be.
    struct Plan {
        /// Truly: as well as from the pieces. Strokes are so thin that a straight cut looks like
        /// that of a mask, and no line differs. Roughly: only for a moment.
        enum class Kind : std::uint8_t { No, Roughly, Truly } kind = Kind::No;
        SceneFrame exact{};                 ///< until the next one; empty if not needed
        std::vector<FrameLine> differing{}; ///< at most mostDiffering + 1
    };
    Plan plan(const FrameWish& wish, const SceneFrame& frame, const std::stop_token& stop);
    /// Such a frame. The picture of all lines is painted first if another drawing or view is wanted
    /// than before.
    QImage paint(const FrameWish& wish, const SceneFrame& frame, const Plan& plan,
                 const Follower& follower, const std::shared_ptr<FrameParts>& parts);

private:
    Plan compared(const FrameWish& wish, const SceneFrame& frame, const std::stop_token& stop);

    DrawingPictures own_; ///< if the wish has none
    SceneClipping exact_;
};

} // namespace app

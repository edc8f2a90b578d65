// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"
#include "app/scene/scene_frame.h"

#include <vector>

namespace app {

/// A frame without the short pieces of cut lines, which a cut drops (CutOptions::leastLength).
/// Subpaths that are not cut stay. Takes some nanoseconds for each line of the scene.
class LongPieces {
public:
    /// `least` is in user units. `frame` and the styles must outlive this object.
    LongPieces(const StyleTable& styles, const SceneFrame& frame, double least);
    LongPieces(const LongPieces&) = delete;
    LongPieces& operator=(const LongPieces&) = delete;

    const SceneFrame& frame() const { return frame_; }

private:
    void drop(const std::vector<bool>& dropped);

    SceneFrame frame_;
    std::vector<SceneFrame::Block> blocks_;
    std::vector<std::vector<Remains>> remains_;
    std::vector<std::vector<clipping::Clipped>> pieces_;
};

/// The rings of an area, one after the other, without the short ones.
std::vector<clipping::Segment> withoutShortRings(std::vector<clipping::Segment> rings,
                                                 double least);

} // namespace app

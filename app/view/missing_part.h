// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_frame.h"
#include "app/view/frame_wish.h"

#include <QRect>

namespace app {

/// A part of the picture of all lines that is still to be painted.
struct MissingPart {
    QRect place;    ///< device pixels
    View view;      ///< of its columns, in all rows
    bool hairlines; ///< painted straight from the scene, instead of `lines`
    Picture lines{};
};

/// The parts of a frame's picture in `places`. If `hairlines`, its drawing has nothing else.
std::vector<MissingPart> missingParts(const FrameWish& wish, const SceneFrame& frame,
                                      std::span<const QRect> places, bool hairlines,
                                      const std::stop_token& stop);

/// Paints the rows of a part that are in the band into the picture that begins at `pixels`. Several
/// threads may paint bands of one picture at the same time.
void paintPart(const MissingPart& part, Band band, const FrameWish& wish,
               const RasterOptions& options, uchar* pixels);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/frame_wish.h"

#include <QRect>

namespace app {

/// A part of the picture of all lines that is still to be painted.
struct MissingPart {
    QRect place{};   ///< device pixels
    View view{};     ///< of its columns, in all rows
    Picture lines{}; ///< to be painted there
};

/// The parts that are missing in a frame: all of it, or what a pan by `moved` device pixels has
/// uncovered. They do not overlap.
std::vector<MissingPart> missingParts(const FrameKey& key, const std::optional<QPoint>& moved);

} // namespace app

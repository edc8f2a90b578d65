// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/algorithm_overlay.h"

namespace ui {

/// Where the boxes of an overlay are: its sentence, its table, its axis of t. Empty: not shown,
/// because there is none, or no room.
struct OverlayBoxes {
    QRectF caption, table, axis;
    std::size_t firstRow = 0, rows = 0; ///< of the table, as many as there is room for

    std::vector<QRectF> all() const { return {caption, table, axis}; }
};
OverlayBoxes boxesOf(const app::Overlay& overlay, const OverlayGround& ground, const QFont& font);

void paintBoxes(QPainter& painter, const app::Overlay& overlay, const OverlayGround& ground,
                const OverlayBoxes& boxes);

} // namespace ui

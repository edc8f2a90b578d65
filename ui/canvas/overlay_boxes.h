// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/overlay.h"
#include "ui/canvas/overlay_ground.h"

#include <QPainter>

namespace ui {

/// The places of an overlay's boxes: sentence, table, axis of t. Empty: not shown, because the
/// overlay has no such box or there is no room.
struct OverlayBoxes {
    QRectF caption, table, axis;
    std::size_t firstRow = 0, rows = 0; ///< the table's visible rows, as many as fit

    std::vector<QRectF> all() const { return {caption, table, axis}; }
};
OverlayBoxes boxesOf(const app::Overlay& overlay, const OverlayGround& ground, const QFont& font);

void paintBoxes(QPainter& painter, const app::Overlay& overlay, const OverlayGround& ground,
                const OverlayBoxes& boxes);

} // namespace ui

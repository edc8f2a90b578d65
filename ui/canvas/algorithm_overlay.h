// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/overlay.h"
#include "ui/canvas/overlay_boxes.h"

#include <QPainter>

namespace ui {

/// Paints areas, lines and marks with their labels, and above them caption, table and axis of t.
/// Uses the painter's font and restores the painter's state.
void paintAlgorithmOverlay(QPainter& painter, const app::Overlay& overlay,
                           const OverlayGround& ground);

} // namespace ui

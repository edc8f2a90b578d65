// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/overlay.h"
#include "ui/look/look.h"

#include <QPainter>

#include <functional>

namespace ui {

/// The surface that an overlay is painted on: a canvas or the microscope.
struct OverlayGround {
    QRectF room; ///< area that it may use, in logical pixels
    std::function<QPointF(const app::Point&)> onScreen;
    const Look& look;
    QColor page;                   ///< the colour behind the drawing and behind labels
    std::vector<QRectF> taken{};   ///< boxes that labels never cover: handles, other labels
    std::vector<QRectF> avoided{}; ///< boxes that labels cover only if there is no other place
};

/// Paints areas, lines and marks with their labels, and above them caption, table and axis of t.
/// Uses the painter's font and restores the painter's state.
void paintAlgorithmOverlay(QPainter& painter, const app::Overlay& overlay,
                           const OverlayGround& ground);

} // namespace ui

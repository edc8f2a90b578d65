// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/overlay.h"
#include "ui/look.h"

#include <QPainter>

#include <functional>

namespace ui {

/// Where an overlay is painted: on a canvas or under the microscope.
struct OverlayGround {
    QRectF room; ///< logical pixels that it may use
    std::function<QPointF(const app::Point&)> onScreen;
    const Look& look;
    QColor page;                   ///< behind the art, and behind labels
    std::vector<QRectF> taken{};   ///< what labels keep off: handles, other labels
    std::vector<QRectF> avoided{}; ///< what they hide only where there is no other place
};

/// Areas, lines, marks with their labels, and over them caption, table and axis of t. In the
/// painter's font; the painter is left as it was.
void paintAlgorithmOverlay(QPainter& painter, const app::Overlay& overlay,
                           const OverlayGround& ground);

} // namespace ui

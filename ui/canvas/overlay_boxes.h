// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"
#include "app/overlays/overlay.h"
#include "ui/look/look.h"

#include <QColor>
#include <QPainter>
#include <QPointF>
#include <QRectF>

#include <functional>
#include <vector>

namespace ui {

/// The surface that an overlay is painted on: a canvas or the microscope.
struct OverlayGround {
    QRectF room; ///< area that it may use, in logical pixels
    std::function<QPointF(const app::Point&)> onScreen;
    const Look& look;              ///< of what lies on it
    QColor page;                   ///< the colour behind the drawing and behind labels
    std::vector<QRectF> taken{};   ///< boxes that labels never cover: handles, other labels
    std::vector<QRectF> avoided{}; ///< boxes that labels cover only if there is no other place
};

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

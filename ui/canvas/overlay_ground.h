// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"
#include "ui/look/look.h"

#include <QColor>
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

} // namespace ui

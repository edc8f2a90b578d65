// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QPainter>
#include <QPainterPath>

namespace ui {

/// The colour of an algorithm: told apart by all kinds of sight, together with its marker.
QColor algorithmColour(const clipping::Algorithm& algorithm, const QPalette& palette);

/// Its marker, filled for the corrected form, hollow for the published one.
void drawMarker(QPainter& painter, const QRectF& box, const clipping::Algorithm& algorithm,
                clipping::Form form, const QPalette& palette);

} // namespace ui

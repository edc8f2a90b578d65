// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/snapping/snap_kind.h"

#include <QPainter>

namespace ui {

/// Paints the glyph of a kind of places in a square, with the painter's pen.
void paintGlyph(QPainter& painter, const app::SnapKind& kind, const QRectF& square);

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/snap_glyph.h"

namespace ui {

void paintGlyph(QPainter& painter, const app::SnapKind& kind, const QRectF& square)
{
    const auto at = [&](const glm::dvec2& p) {
        return square.center() + QPointF(p.x * square.width() / 2, p.y * square.height() / 2);
    };
    for (const auto& stroke : kind.glyph)
        painter.drawLine(at(stroke.a), at(stroke.b));
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/picking_marks.h"

namespace ui {

Picked pickedAt(const app::Point& pointer, const Workbench& bench)
{
    if (const auto segment = bench.picking.nearest(pointer, bench.inDrawing(reach)))
        return {segment, bench.session.scene.lines().objectOf(*segment)};
    return {{}, bench.picking.areaAt(pointer)};
}

void paintSelectionBox(QPainter& painter, const Workbench& bench, const app::Point& from,
                       const app::Point& to, Qt::PenStyle edge)
{
    QColor tint = bench.look.selection;
    tint.setAlphaF(0.08F);
    painter.setBrush(tint);
    painter.setPen(QPen(bench.look.selection, 1, edge));
    painter.drawRect(QRectF(bench.onScreen(from), bench.onScreen(to)).normalized());
}

} // namespace ui

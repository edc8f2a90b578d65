// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/selection_marks.h"

#include "ui/tools/end_drag.h"
#include "ui/tools/pivot_marks.h"

#include <glm/common.hpp>

namespace ui {
namespace {

constexpr double outside = 6, quietOutside = 4; // pixels, from the objects to the box
constexpr double nearby = 24;                   // pixels, to the pointer
constexpr double handleRadius = 4, casing = 3;

QRectF around(const QPointF& centre)
{
    return {centre - QPointF(handleRadius + 1, handleRadius + 1),
            centre + QPointF(handleRadius + 1, handleRadius + 1)};
}

} // namespace

clipping::Window SelectionMarks::boxAround(const clipping::Window& bounds, const Workbench& bench)
{
    const double more = bench.inDrawing(isQuiet(bench.session) ? quietOutside : outside);
    return {bounds.min - more, bounds.max + more};
}

bool SelectionMarks::isNear(const app::Point& screen, const clipping::Window& bounds,
                            const Workbench& bench)
{
    const app::Point min = bench.view.toScreen(bounds.min), max = bench.view.toScreen(bounds.max);
    // The handle that rotates is above.
    return screen.x >= min.x - nearby && screen.x <= max.x + nearby
           && screen.y >= min.y - 2 * nearby && screen.y <= max.y + nearby;
}

bool SelectionMarks::isQuiet(const app::Session& session)
{
    const app::ObjectRanges& selection = session.selection();
    return selection.size() == 1
           && std::holds_alternative<app::TextRecipe>(
               session.now().objects()[selection.first()].particulars().recipe);
}

void SelectionMarks::paint(QPainter& painter, const Workbench& bench,
                           const clipping::Window& bounds, bool near)
{
    const clipping::Window box = boxAround(bounds, bench);
    const QRectF frame(bench.onScreen(box.min), bench.onScreen(box.max));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(bench.look.paper, casing));
    painter.drawRect(frame);
    painter.setPen(QPen(bench.look.selection, 1));
    painter.drawRect(frame);
    if (isQuiet(bench.session) && !near)
        return;
    painter.setPen(QPen(bench.look.selection, 1.5));
    painter.setBrush(bench.look.paper);
    for (const app::PlacedHandle& placed : app::placedHandles(box, bench.view))
        painter.drawEllipse(QPointF(placed.screen.x, placed.screen.y), handleRadius, handleRadius);
}

QRectF selectionOnScreen(const Workbench& bench)
{
    const clipping::Window& bounds = *bench.session.selectionBounds();
    return QRectF(bench.onScreen(bounds.min), bench.onScreen(bounds.max)).normalized();
}

std::vector<QRectF> selectionMarks(const Workbench& bench)
{
    std::vector<QRectF> places;
    const clipping::Window& bounds = *bench.session.selectionBounds();
    if (lineWithHandles(bench.session)) {
        for (const app::Point& end : EndDrag::handles(bench))
            places.push_back(around({end.x, end.y}));
    } else {
        const clipping::Window box = SelectionMarks::boxAround(bounds, bench);
        for (const app::PlacedHandle& placed : app::placedHandles(box, bench.view))
            places.push_back(around({placed.screen.x, placed.screen.y}));
    }
    places.push_back(around(PivotMarks::rotationHandle(bench)));
    return places;
}

} // namespace ui

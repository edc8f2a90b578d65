// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/selection_marks.h"

#include "app/session/selection_frame.h"
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

app::WindowFrame SelectionMarks::around(const app::WindowFrame& frame, const Workbench& bench)
{
    const double more = bench.inDrawing(isQuiet(bench.session) ? quietOutside : outside);
    return {{frame.box.min - more, frame.box.max + more}, frame.angle};
}

std::vector<app::PlacedHandle> SelectionMarks::handles(const app::WindowFrame& around,
                                                       const Workbench& bench)
{
    std::vector<app::PlacedHandle> placed = app::placedHandles(around.box, bench.view);
    for (app::PlacedHandle& handle : placed)
        handle.screen = app::rotated(around, bench.view, handle.screen);
    return placed;
}

bool SelectionMarks::isNear(const app::Point& screen, const app::WindowFrame& frame,
                            const Workbench& bench)
{
    const app::Point at = app::unrotated(frame, bench.view, screen);
    const app::Point min = bench.view.toScreen(frame.box.min);
    const app::Point max = bench.view.toScreen(frame.box.max);
    // The handle that rotates is above.
    return at.x >= min.x - nearby && at.x <= max.x + nearby && at.y >= min.y - 2 * nearby
           && at.y <= max.y + nearby;
}

bool SelectionMarks::isQuiet(const app::Session& session)
{
    return std::holds_alternative<app::TextRecipe>(app::onlyRecipe(session));
}

void SelectionMarks::paint(QPainter& painter, const Workbench& bench, const app::WindowFrame& frame,
                           bool near)
{
    const app::WindowFrame box = around(frame, bench);
    QPolygonF outline;
    for (const app::Point& corner : app::cornersOf(box))
        outline << bench.onScreen(corner);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(bench.look.paper, casing));
    painter.drawPolygon(outline);
    painter.setPen(QPen(bench.look.selection, 1));
    painter.drawPolygon(outline);
    if (isQuiet(bench.session) && !near)
        return;
    painter.setPen(QPen(bench.look.selection, 1.5));
    painter.setBrush(bench.look.paper);
    for (const app::PlacedHandle& placed : handles(box, bench))
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
    if (lineWithHandles(bench.session)) {
        for (const app::Point& end : EndDrag::handles(bench))
            places.push_back(around({end.x, end.y}));
    } else {
        const app::WindowFrame box =
            SelectionMarks::around(*app::selectionFrame(bench.session), bench);
        for (const app::PlacedHandle& placed : SelectionMarks::handles(box, bench))
            places.push_back(around({placed.screen.x, placed.screen.y}));
    }
    places.push_back(around(PivotMarks::rotationHandle(bench)));
    return places;
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/pivot_marks.h"

#include "ui/look/text.h"
#include "ui/tools/end_drag.h"
#include "ui/tools/selection_marks.h"

#include <glm/geometric.hpp>

namespace ui {
namespace {

constexpr double aboveBox = 28;                           // pixels, to the rotation handle
constexpr double handleReach = 8, pivotReach = 6;         // pixels
constexpr double leastForPivot = 72, arm = 7, radius = 4; // pixels
constexpr double besideRotation = 24;                     // pixels, to the pivot that waits there

/// The place of the rotation handle on the screen.
app::Point handleAbove(const clipping::Window& box, const app::View& view)
{
    return view.toScreen(app::placeOf({0, -1}, box)) - app::Point(0, aboveBox);
}

/// Whether the cross and the rotation handle would be in the way: of a line, a text or a small
/// selection, until the cross is put elsewhere.
bool areInTheWay(const clipping::Window& box, const Workbench& bench)
{
    const app::Point size = bench.view.toScreen(box.max) - bench.view.toScreen(box.min);
    return !bench.session.pivot.isMoved()
           && (lineWithHandles(bench.session) || SelectionMarks::isQuiet(bench.session)
               || std::max(size.x, size.y) < leastForPivot);
}

/// The place of the cross on the screen. Where it would be in the way, it waits beside the rotation
/// handle.
app::Point crossAt(const clipping::Window& box, const Workbench& bench)
{
    return areInTheWay(box, bench) ? handleAbove(box, bench.view) + app::Point(besideRotation, 0)
                                   : bench.view.toScreen(bench.session.pivot.at());
}

} // namespace

PivotMarks::Mark PivotMarks::at(const app::Point& screen, const Workbench& bench)
{
    const auto& box = bench.session.selectionBounds();
    if (!box)
        return Mark::None;
    if (glm::distance(screen, handleAbove(*box, bench.view)) <= handleReach)
        return Mark::Rotation;
    return glm::distance(screen, crossAt(*box, bench)) <= pivotReach ? Mark::Pivot : Mark::None;
}

QString PivotMarks::hint(Mark mark)
{
    return mark == Mark::Pivot      ? Text::tr("Drag the cross to the point about which the "
                                                    "selection is rotated, flipped and scaled.")
           : mark == Mark::Rotation ? Text::tr("Drag to rotate about the cross. Shift: 15° steps.")
                                    : QString();
}

QPointF PivotMarks::rotationHandle(const Workbench& bench)
{
    const app::Point at = handleAbove(*bench.session.selectionBounds(), bench.view);
    return {at.x, at.y};
}

void PivotMarks::paint(QPainter& painter, const Workbench& bench, bool near)
{
    const auto& box = bench.session.selectionBounds();
    if (!box || (!near && areInTheWay(*box, bench)))
        return;
    const app::Point cross = crossAt(*box, bench);
    paintPivot(painter, {cross.x, cross.y}, bench.look);
    const QPointF at = rotationHandle(bench);
    const bool isLine = lineWithHandles(bench.session).has_value(); // which has no box
    const clipping::Window around = isLine ? *box : SelectionMarks::boxAround(*box, bench);
    const QPointF top = bench.onScreen(app::placeOf({0, -1}, around));
    painter.setPen(QPen(bench.look.selection, 1));
    painter.drawLine(top - QPointF(0, radius), at + QPointF(0, radius));
    painter.setPen(QPen(bench.look.selection, 1.5));
    painter.setBrush(bench.look.paper);
    painter.drawEllipse(at, radius, radius);
}

void PivotMarks::paintPivot(QPainter& painter, const QPointF& at, const Look& look)
{
    painter.setPen(QPen(look.selection, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, radius, radius);
    painter.drawLine(at - QPointF(arm, 0), at + QPointF(arm, 0));
    painter.drawLine(at - QPointF(0, arm), at + QPointF(0, arm));
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/pivot_marks.h"

#include "app/session/selection_frame.h"
#include "app/view/frame_handles.h"
#include "ui/look/text.h"
#include "ui/tools/end_drag.h"
#include "ui/tools/selection_marks.h"

#include <glm/geometric.hpp>

namespace ui {
namespace {

constexpr double handleReach = 8, pivotReach = 6;         // pixels
constexpr double leastForPivot = 72, arm = 7, radius = 4; // pixels
constexpr double besideRotation = 24;                     // pixels, to the pivot that waits there

/// Whether the cross and the rotation handle would be in the way: of a line, a text or a small
/// selection, until the cross is put elsewhere.
bool areInTheWay(const app::WindowFrame& frame, const Workbench& bench)
{
    const app::Point size = bench.view.toScreen(frame.box.max) - bench.view.toScreen(frame.box.min);
    return !bench.session.pivot.isMoved()
           && (lineWithHandles(bench.session) || SelectionMarks::isQuiet(bench.session)
               || std::max(size.x, size.y) < leastForPivot);
}

/// The place of the cross on the screen. Where it would be in the way, it waits beside the rotation
/// handle.
app::Point crossAt(const app::WindowFrame& frame, const Workbench& bench)
{
    return areInTheWay(frame, bench)
               ? app::placeOfRotation(frame, bench.view) + app::Point(besideRotation, 0)
               : bench.view.toScreen(bench.session.pivot.at());
}

} // namespace

PivotMarks::Mark PivotMarks::at(const app::Point& screen, const Workbench& bench)
{
    const auto frame = app::selectionFrame(bench.session);
    if (!frame)
        return Mark::None;
    if (glm::distance(screen, app::placeOfRotation(*frame, bench.view)) <= handleReach)
        return Mark::Rotation;
    return glm::distance(screen, crossAt(*frame, bench)) <= pivotReach ? Mark::Pivot : Mark::None;
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
    const app::Point at = app::placeOfRotation(*app::selectionFrame(bench.session), bench.view);
    return {at.x, at.y};
}

void PivotMarks::paint(QPainter& painter, const Workbench& bench, bool near)
{
    const auto frame = app::selectionFrame(bench.session);
    if (!frame || (!near && areInTheWay(*frame, bench)))
        return;
    const app::Point cross = crossAt(*frame, bench);
    paintPivot(painter, {cross.x, cross.y}, bench.look);
    const QPointF at = rotationHandle(bench);
    const bool isLine = lineWithHandles(bench.session).has_value(); // which has no frame
    const app::WindowFrame around = isLine ? *frame : SelectionMarks::around(*frame, bench);
    const QLineF stem(at,
                      bench.onScreen(app::outOfFrame(around, app::placeOf({0, -1}, around.box))));
    const QPointF along = stem.unitVector().p2() - at;
    painter.setPen(QPen(bench.look.selection, 1));
    painter.drawLine(stem.p2() - along * radius, at + along * radius);
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

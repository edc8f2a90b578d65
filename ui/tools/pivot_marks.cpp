// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/pivot_marks.h"

#include "ui/tools/end_drag.h"

#include <glm/geometric.hpp>

namespace ui {
namespace {

constexpr double aboveBox = 28;                           // pixels, to the rotation handle
constexpr double handleReach = 8, pivotReach = 6;         // pixels
constexpr double leastForPivot = 72, arm = 7, radius = 4; // pixels

/// The place of the rotation handle on the screen.
app::Point rotationHandle(const clipping::Window& box, const app::View& view)
{
    return view.toScreen(app::placeOf({0, -1}, box)) - app::Point(0, aboveBox);
}

} // namespace

app::Point PivotMarks::pivot(const Workbench& bench) const
{
    const auto bounds = bench.session.selectionBounds().value_or(clipping::Window{});
    const bool same = bounds.min == bounds_.min && bounds.max == bounds_.max;
    if (pivot_ && same && selection_ == bench.session.selection())
        return *pivot_;
    return app::placeOf(app::Handle{}, bounds);
}

void PivotMarks::put(const app::Point& pivot, const Workbench& bench)
{
    pivot_ = pivot;
    selection_ = bench.session.selection();
    bounds_ = bench.session.selectionBounds().value_or(clipping::Window{});
}

/// In a line and in small objects it would be in the way of moving them.
bool PivotMarks::isShown(const Workbench& bench) const
{
    const auto& box = bench.session.selectionBounds();
    if (!box || lineWithHandles(bench.session))
        return false;
    const app::Point size = bench.view.toScreen(box->max) - bench.view.toScreen(box->min);
    return std::max(size.x, size.y) >= leastForPivot;
}

PivotMarks::Mark PivotMarks::at(const app::Point& screen, const Workbench& bench) const
{
    const auto& box = bench.session.selectionBounds();
    if (!box)
        return Mark::None;
    if (glm::distance(screen, rotationHandle(*box, bench.view)) <= handleReach)
        return Mark::Rotation;
    const app::Point place = bench.view.toScreen(pivot(bench));
    return isShown(bench) && glm::distance(screen, place) <= pivotReach ? Mark::Pivot : Mark::None;
}

void PivotMarks::paint(QPainter& painter, const Workbench& bench) const
{
    const auto& box = bench.session.selectionBounds();
    if (!box)
        return;
    if (isShown(bench))
        paintPivot(painter, bench.onScreen(pivot(bench)), bench.look);
    const app::Point handle = rotationHandle(*box, bench.view);
    const QPointF at(handle.x, handle.y), top = bench.onScreen(app::placeOf({0, -1}, *box));
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

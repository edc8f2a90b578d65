// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/aim.h"

#include <glm/geometric.hpp>

namespace ui {

app::SnapQuery Aim::query(const app::Point& raw) const
{
    const Workbench& bench = held_.bench();
    app::SnapQuery query{raw, bench.inDrawing(snapReach), bench.snapTo};
    query.grid = bench.grid();
    query.guides = bench.guides();
    return query;
}

app::SnapQuery Aim::queryOfTool(const app::Point& raw) const
{
    app::SnapQuery query = this->query(raw);
    held_.as<Snaps>().limit(query);
    const auto& readout = typing_.readout();
    const auto* measure = readout ? readout->gauge().measure : nullptr;
    if (measure == &app::lengthAndAngle() || measure == &app::lengthAndAngle(app::Anchor::Centre))
        query.from = readout->gauge().start.from;
    if (held_.busy())
        query.seen = held_.view().visible();
    return query;
}

// Ctrl suspends snapping.
Pointer Aim::snapped(const QPointF& screen, const app::SnapQuery& query, Qt::MouseButtons buttons,
                     Qt::KeyboardModifiers modifiers)
{
    const bool free = query.to == app::SnapTo::Nothing || modifiers & Qt::ControlModifier;
    snap_ = free ? std::nullopt : held_.bench().snapper.at(query);
    const app::Point place = snap_ ? snap_->point : query.pointer;
    return {place, query.pointer, {screen.x(), screen.y()}, buttons, modifiers, place};
}

Pointer Aim::withoutTool(const QPointF& screen, Qt::KeyboardModifiers modifiers)
{
    const app::Point raw = held_.view().toDrawing({screen.x(), screen.y()});
    return snapped(screen, query(raw), Qt::LeftButton, modifiers);
}

Pointer Aim::at(const QPointF& screen, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers)
{
    const app::Point raw = held_.view().toDrawing({screen.x(), screen.y()});
    Pointer pointer = snapped(screen, queryOfTool(raw), buttons, modifiers);
    if (typing_.readout() && held_.busy() && modifiers & Qt::ShiftModifier)
        pointer.position = pointer.steered = typing_.readout()->toStep(pointer.position);
    if (snap_ && glm::distance(pointer.position, snap_->point) > held_.bench().inDrawing(0.1))
        snap_.reset(); // with Shift the line does not lead there
    typing_.hold(pointer);
    return pointer;
}

} // namespace ui

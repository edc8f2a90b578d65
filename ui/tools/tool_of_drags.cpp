// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_of_drags.h"

#include "ui/tools/shape_drawing.h"

#include <algorithm>
#include <utility>

namespace ui {

Drag* ToolOfDrags::going() const
{
    const auto found = std::ranges::find_if(drags_, &Drag::going);
    return found == drags_.end() ? nullptr : *found;
}

void ToolOfDrags::move(const Pointer& pointer, Workbench& bench)
{
    if (!busy())
        return look(pointer, bench);
    if (!going() && dragged(pressed_->screen, pointer))
        startDrag(bench);
    if (Drag* drag = going())
        drag->proceed(pointer, bench);
}

void ToolOfDrags::release(const Pointer& pointer, Workbench& bench)
{
    if (!pressed_)
        return; // a gesture that was begun by a key goes on
    if (!going())
        move(pointer, bench); // it may begin the drag
    const Pointer pressed = *std::exchange(pressed_, std::nullopt);
    Drag* drag = going();
    if (!drag || !drag->finish(pointer, bench))
        click(pressed, bench);
}

void ToolOfDrags::cancel(Workbench& bench)
{
    pressed_.reset();
    for (Drag* drag : drags_)
        drag->cancel(bench);
}

void ToolOfDrags::forgetSteps(Workbench& bench)
{
    for (Drag* drag : drags_)
        drag->end(bench);
}

std::optional<app::Gauge> ToolOfDrags::gauge(const Workbench& bench) const
{
    if (busy())
        return going() ? going()->gauge(bench) : std::nullopt;
    for (const Drag* drag : drags_)
        if (drag->canReopen(bench))
            return drag->gauge(bench);
    return std::nullopt;
}

void ToolOfDrags::accept(const app::GestureEnd& end, Workbench& bench)
{
    pressed_.reset();
    if (Drag* drag = going())
        drag->accept(end, bench);
}

/// Only one of them has made the last step.
void ToolOfDrags::reopen(Workbench& bench)
{
    for (Drag* drag : drags_)
        drag->reopen(bench);
}

bool ToolOfDrags::corrects() const { return std::ranges::any_of(drags_, &Drag::corrects); }

void ToolOfDrags::limit(app::SnapQuery& query) const
{
    going() ? going()->limit(query) : void(query.to = app::SnapTo::Nothing);
}

void ToolOfDrags::paint(QPainter& painter, const Workbench& bench) const
{
    for (const Drag* drag : drags_)
        drag->paint(painter, bench);
}

} // namespace ui

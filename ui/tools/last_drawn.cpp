// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/last_drawn.h"

namespace ui {

int LastDrawn::stepsDone(const Workbench& bench)
{
    return bench.session.history.forgotten() + bench.session.history.index();
}

void LastDrawn::remember(const Gesture& gesture, const Workbench& bench)
{
    gesture_ = gesture;
    steps_ = stepsDone(bench);
    open_ = false;
}

std::optional<LastDrawn::Gesture> LastDrawn::reopen(Workbench& bench)
{
    app::History& history = bench.session.history;
    if (!gesture_ || open_ || stepsDone(bench) != steps_ || history.canRedo() || !history.canUndo())
        return std::nullopt;
    history.undo();
    open_ = true;
    return gesture_;
}

std::optional<app::Point> LastDrawn::end() const
{
    return open_ ? std::optional(gesture_->to) : std::nullopt;
}

void LastDrawn::restore(Workbench& bench)
{
    if (std::exchange(open_, false))
        bench.session.history.redo();
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/last_step.h"

namespace ui {
void LastStep::remember(const Workbench& bench)
{
    steps_ = bench.session.history.stepsDone();
    open_ = false;
    QObject::disconnect(others_);
    others_ = QObject::connect(&bench.session.history, &app::History::pushed, [this] {
        steps_.reset(); // as many steps may be other steps
        open_ = false;
    });
}

bool LastStep::canReopen(const Workbench& bench) const
{
    const app::History& history = bench.session.history;
    return !open_ && steps_ == history.stepsDone() && !history.canRedo() && history.canUndo();
}

bool LastStep::reopen(Workbench& bench)
{
    if (!canReopen(bench))
        return false;
    bench.session.history.undo();
    open_ = true;
    return true;
}

void LastStep::restore(Workbench& bench)
{
    if (std::exchange(open_, false))
        bench.session.history.redo();
}

} // namespace ui

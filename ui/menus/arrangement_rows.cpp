// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/arrange_selection.h"
#include "app/session/arrangements.h"
#include "ui/menus/menu_rows.h"
#include "ui/window/main_window.h"

namespace ui {

namespace {

using Kind = app::Arrangement::Kind;

ActionInfo arrange(const app::Arrangement& how)
{
    ActionInfo row{
        .key = how.key,
        .text = how.text,
        .run = [&how](MainWindow& w) { how.run(w.session()); },
        .refusal = [&how](const MainWindow& w) { return app::refusal(how, w.session()); },
    };
    if (!how.shortcut.isEmpty()) {
        row.keys = {QKeySequence(how.shortcut)};
        row.scope = ShortcutScope::Canvas;
    }
    return row;
}

ActionInfo alignTo(const app::AlignmentTarget& target)
{
    return {
        .key = target.key,
        .text = target.name,
        .run = [&target](MainWindow& w) { app::alignTo(w.session(), target); },
        .checked =
            [&target](const MainWindow& w) { return w.session().arrange.alignTo == target.key; },
        .group = "align-to",
        .paletteOnly = true, // the bar of the tool Select has a list of them
    };
}

std::vector<ActionInfo> rowsOf(Kind kind)
{
    std::vector<ActionInfo> rows;
    for (const app::Arrangement& how : app::arrangements())
        if (how.kind == kind)
            rows.push_back(arrange(how));
    return rows;
}

} // namespace

std::vector<ActionInfo> turnRows() { return rowsOf(Kind::Turn); }

std::vector<ActionInfo> arrangementRows()
{
    std::vector<ActionInfo> targets;
    for (const app::AlignmentTarget& target : app::alignmentTargets())
        targets.push_back(alignTo(target));
    const std::vector<ActionInfo> separator(1);
    return joined({rowsOf(Kind::Align), targets, separator, rowsOf(Kind::Spread), separator,
                   rowsOf(Kind::SameSize)});
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/arrange_selection.h"
#include "app/session/arrangements.h"
#include "ui/menus/object_rows.h"
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
        .submenu = how.submenu,
        .refusal = [&how](const MainWindow& w) { return app::refusal(how, w.session()); },
    };
    if (!how.shortcut.isEmpty()) {
        row.keys = {QKeySequence(how.shortcut)};
        row.scope = ShortcutScope::Canvas;
    }
    return row;
}

ActionInfo alignTo(const app::AlignmentTarget& target, const QString& submenu)
{
    return {
        .key = target.key,
        .text = target.name,
        .run = [&target](MainWindow& w) { app::alignTo(w.session(), target); },
        .checked =
            [&target](const MainWindow& w) { return w.session().arrange.alignTo == target.key; },
        .group = "align-to",
        .submenu = submenu,
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
    std::vector<ActionInfo> rows = rowsOf(Kind::Align);
    const QString align = rows.front().submenu;
    for (const app::AlignmentTarget& target : app::alignmentTargets())
        rows.push_back(alignTo(target, align));
    for (const Kind kind : {Kind::Spread, Kind::SameSize})
        for (ActionInfo& row : rowsOf(kind))
            rows.push_back(std::move(row));
    return rows;
}

} // namespace ui

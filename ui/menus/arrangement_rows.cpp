// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/arrange_selection.h"
#include "app/session/arrangements.h"
#include "ui/menus/object_rows.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>

#include <array>

namespace ui {

namespace {

using Kind = app::Arrangement::Kind;

QString tr(const char* text) { return QCoreApplication::translate("ObjectMenu", text); }

/// Why it cannot run; in the order of the least number of objects, from 1.
QString needsOf(const app::Arrangement& how)
{
    const std::array needs{tr("Nothing is selected. Select an object first."),
                           tr("Select several objects first."),
                           tr("Select at least three objects first: the outer two stay.")};
    return needs.at(how.least - 1);
}

ActionInfo arrange(const app::Arrangement& how)
{
    ActionInfo row{
        .key = how.key,
        .text = how.text,
        .run = [&how](MainWindow& w) { how.run(w.session()); },
        .enabled =
            [&how](const MainWindow& w) { return w.session().selection().size() >= how.least; },
        .needs = needsOf(how),
        .submenu = how.submenu,
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
        .run = [&target](MainWindow& w) { w.session().arrange.alignTo = target.key; },
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

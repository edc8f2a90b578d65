// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/arrange_selection.h"
#include "ui/menus/object_rows.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>

namespace ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("ObjectMenu", text); }

bool severalSelected(const MainWindow& window) { return window.session().selection().size() > 1; }

ActionInfo arrange(std::string_view key, const QString& text,
                   std::function<void(app::Session&)> run, const QString& submenu)
{
    return {
        .key = key,
        .text = text,
        .run = [run = std::move(run)](MainWindow& w) { run(w.session()); },
        .enabled = severalSelected,
        .needs = tr("Select several objects first."),
        .submenu = submenu,
    };
}

ActionInfo aligned(std::string_view key, const QString& text, int axis, app::AlignTo side)
{
    ActionInfo row = arrange(
        key, text, [axis, side](app::Session& s) { app::align(s, axis, side); }, tr("&Align"));
    // One object can be aligned to the page.
    row.enabled = [](const MainWindow& w) { return !w.session().selection().empty(); };
    row.needs = tr("Nothing is selected. Select an object first.");
    return row;
}

ActionInfo alignTo(const app::AlignmentTarget& ground)
{
    return {
        .key = ground.key,
        .text = ground.name,
        .run = [&ground](MainWindow& w) { w.session().arrange.ground = ground.key; },
        .checked =
            [&ground](const MainWindow& w) { return w.session().arrange.ground == ground.key; },
        .group = "align-to",
        .submenu = tr("&Align"),
    };
}

} // namespace

std::vector<ActionInfo> arrangementRows()
{
    using app::AlignTo, app::Session;
    const QString spread = tr("S&pread evenly"), size = tr("Make same si&ze");
    std::vector<ActionInfo> rows{
        aligned("align-left", tr("&Left sides"), 0, AlignTo::Least),
        aligned("align-centre", tr("&Middles, side by side"), 0, AlignTo::Middle),
        aligned("align-right", tr("&Right sides"), 0, AlignTo::Most),
        aligned("align-top", tr("&Tops"), 1, AlignTo::Least),
        aligned("align-middle", tr("M&iddles, one above the other"), 1, AlignTo::Middle),
        aligned("align-bottom", tr("&Bottoms"), 1, AlignTo::Most),
    };
    for (const app::AlignmentTarget& ground : app::alignmentTargets())
        rows.push_back(alignTo(ground));
    const auto add = [&](ActionInfo row) { rows.push_back(std::move(row)); };
    add(arrange(
        "spread-horizontally", tr("&Horizontally"), [](Session& s) { app::spreadEvenly(s, 0); },
        spread));
    add(arrange(
        "spread-vertically", tr("&Vertically"), [](Session& s) { app::spreadEvenly(s, 1); },
        spread));
    add(arrange(
        "same-width", tr("&Width"), [](Session& s) { app::makeSameSize(s, true, false); }, size));
    add(arrange(
        "same-height", tr("&Height"), [](Session& s) { app::makeSameSize(s, false, true); }, size));
    add(arrange(
        "same-size", tr("&Both"), [](Session& s) { app::makeSameSize(s, true, true); }, size));
    return rows;
}

} // namespace ui

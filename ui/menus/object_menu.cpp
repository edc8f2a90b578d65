// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/transformation.h"
#include "app/session/arrange_selection.h"
#include "ui/dialogs/repeat_dialog.h"
#include "ui/editing/transforming.h"
#include "ui/menus/actions.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>

namespace ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("ObjectMenu", text); }

bool someSelected(const MainWindow& window) { return !window.session().selection().empty(); }

QString nothingSelected() { return tr("Nothing is selected. Select an object first."); }

/// Begins a transformation that takes the pointer or numbers.
ActionInfo begin(const app::Transformation& kind)
{
    return {
        .key = kind.key,
        .text = kind.name,
        .keys = {QKeySequence(QString(kind.letter))},
        .scope = ShortcutScope::Canvas,
        .run = [&kind](MainWindow& w) { w.canvas().transform(kind); },
        .enabled = someSelected,
        .needs = kind.needs,
    };
}

ActionInfo turn(std::string_view key, const QString& text, const QKeySequence& shortcut, Turn turn)
{
    return {
        .key = key,
        .text = text,
        .keys = {shortcut},
        .scope = ShortcutScope::Canvas,
        .run = [turn](MainWindow& w) { turnSelection(w.session(), turn); },
        .enabled = someSelected,
        .needs = nothingSelected(),
    };
}

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
    row.enabled = someSelected; // one object can be aligned to the page
    row.needs = nothingSelected();
    return row;
}

ActionInfo alignTo(const app::AlignmentGround& ground)
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

std::vector<ActionInfo> arrangements()
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
    for (const app::AlignmentGround& ground : app::alignmentGrounds())
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

ActionInfo repeat()
{
    return {
        .key = "repeat",
        .text = tr("Repeat in ro&ws or around a point…"),
        .keys = {QKeySequence("Ctrl+Shift+D")},
        .run =
            [](MainWindow& w) {
                auto* dialog = new RepeatDialog(w.session(), &w);
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->setModal(true);
                dialog->show();
            },
        .enabled = someSelected,
        .needs = nothingSelected(),
    };
}

ActionInfo scaleStrokes()
{
    using app::StrokeScaling;
    return {
        .key = "scale-strokes",
        .text = tr("Scale stroke &widths too"),
        .run =
            [](MainWindow& w) {
                StrokeScaling& strokes = w.session().arrange.strokes;
                strokes =
                    strokes == StrokeScaling::Keep ? StrokeScaling::Scale : StrokeScaling::Keep;
            },
        .checked =
            [](const MainWindow& w) { return w.session().arrange.strokes == StrokeScaling::Scale; },
    };
}

} // namespace

MenuInfo objectMenu()
{
    using K = QKeySequence;
    MenuInfo menu{.title = tr("&Object")};
    for (const app::Transformation& kind : app::transformations())
        menu.rows.push_back(begin(kind));
    const std::vector<ActionInfo> more{
        {},
        turn("rotate-left", tr("Rotate 90° &left"), K("Shift+O"), Turn::Left),
        turn("rotate-right", tr("Rotate 90° r&ight"), K("Alt+Shift+O"), Turn::Right),
        turn("flip-horizontal", tr("Flip &horizontally"), K("Shift+H"), Turn::FlipAcross),
        turn("flip-vertical", tr("Flip &vertically"), K("Shift+V"), Turn::FlipDown),
        scaleStrokes(),
        {},
        repeat(),
    };
    menu.rows.insert(menu.rows.end(), more.begin(), more.end());
    menu.rows.push_back({});
    for (ActionInfo& row : arrangements())
        menu.rows.push_back(std::move(row));
    return menu;
}

} // namespace ui

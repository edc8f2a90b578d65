// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/transformation.h"
#include "ui/dialogs/repeat_dialog.h"
#include "ui/editing/transforming.h"
#include "ui/menus/object_rows.h"
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

ActionInfo repeat()
{
    return {
        .key = "repeat",
        .text = tr("Repeat in rows or aroun&d a point…"),
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
    for (const auto& rows : {arrangementRows(), styleRows(), pathRows()})
        menu.rows.insert(menu.rows.end(), rows.begin(), rows.end());
    return menu;
}

} // namespace ui

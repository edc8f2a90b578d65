// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/transformation.h"
#include "app/session/arrange_selection.h"
#include "ui/dialogs/repeat_dialog.h"
#include "ui/look/text.h"
#include "ui/menus/object_rows.h"
#include "ui/window/main_window.h"

namespace ui {

namespace {

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

ActionInfo repeat()
{
    return {
        .key = "repeat",
        .text = Text::tr("Repeat in rows or aroun&d a point…"),
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
        .text = Text::tr("Scale stroke &widths too"),
        .run =
            [](MainWindow& w) {
                const bool on = w.session().arrange.strokes == StrokeScaling::Scale;
                app::scaleStrokes(w.session(), on ? StrokeScaling::Keep : StrokeScaling::Scale);
            },
        .checked =
            [](const MainWindow& w) { return w.session().arrange.strokes == StrokeScaling::Scale; },
    };
}

} // namespace

MenuInfo objectMenu()
{
    MenuInfo menu{.title = Text::tr("&Object"), .rows = groupRows()};
    const auto add = [&menu](const std::vector<ActionInfo>& rows) {
        menu.rows.insert(menu.rows.end(), rows.begin(), rows.end());
    };
    menu.rows.emplace_back();
    for (const app::Transformation& kind : app::transformations())
        menu.rows.push_back(begin(kind));
    menu.rows.emplace_back();
    add(turnRows());
    add({scaleStrokes(), {}, repeat(), {}});
    add(orderRows());
    add(arrangementRows());
    add(styleRows());
    add(pathRows());
    return menu;
}

} // namespace ui

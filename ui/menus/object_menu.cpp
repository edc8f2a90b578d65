// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/transformation.h"
#include "app/session/arrange_selection.h"
#include "ui/dialogs/repeat_dialog.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/window/main_window.h"

namespace ui {

namespace {

/// What was just drawn is selected by the transformation.
bool someToTransform(const MainWindow& window)
{
    return someSelected(window) || !app::justAdded(window.session()).empty();
}

/// Begins a transformation that takes the pointer or numbers.
ActionInfo begin(const app::Transformation& kind)
{
    return {
        .key = kind.key,
        .text = kind.name,
        .keys = {QKeySequence(QString(kind.letter))},
        .scope = ShortcutScope::Canvas,
        .run = [&kind](MainWindow& w) { w.canvas().transform(kind); },
        .enabled = someToTransform,
        .needs = kind.needs,
    };
}

/// What is repeated: the selection, else what the last step has drawn or copied.
app::ObjectRanges toRepeat(const app::Session& session)
{
    return session.selection().empty() ? app::justAdded(session) : session.selection();
}

ActionInfo repeat()
{
    return {
        .key = "repeat",
        .text = Text::tr("Repeat in rows or aroun&d a point…"),
        .keys = {QKeySequence("Ctrl+Shift+D")},
        .run =
            [](MainWindow& w) {
                w.session().select(toRepeat(w.session()));
                auto* dialog = new RepeatDialog(w.session(), &w);
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->setModal(true);
                dialog->show();
            },
        .enabled = [](const MainWindow& w) { return !toRepeat(w.session()).empty(); },
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
    const std::vector<ActionInfo> separator(1);
    std::vector<ActionInfo> begins;
    for (const app::Transformation& kind : app::transformations())
        begins.push_back(begin(kind));
    return {
        .title = Text::tr("&Object"),
        .rows = joined(
            {inSubmenu(Text::tr("&Draw"),
                       {toolRows({"line", "polyline", "pen", "arc", "pencil"}), separator,
                        toolRows({"rectangle", "ellipse", "polygon", "star"}), separator,
                        toolRows({"text"})}),
             separator,
             groupRows(),
             separator,
             inSubmenu(Text::tr("Tra&nsform"),
                       {begins, separator, turnRows(), separator, {scaleStrokes(), repeat()}}),
             inSubmenu(Text::tr("&Order"), {orderRows()}),
             {moveToLayerRow()},
             inSubmenu(Text::tr("&Align and spread"), {arrangementRows()}),
             inSubmenu(Text::tr("S&tyle"), {styleRows()}),
             separator,
             inSubmenu(Text::tr("&Path"), {pathRows()}),
             {convertRow()}}),
        .ofDrawing = true,
    };
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_steps.h"
#include "app/session/convert_selection.h"
#include "ui/bars/option_bar.h"
#include "ui/dialogs/join_dialog.h"
#include "ui/files/files.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/window/main_window.h"

namespace ui {

namespace {

constexpr std::size_t types = 3; // of nodes: the first steps, in the order of app::NodeType

/// Whether all selected nodes have this type.
bool hasType(const MainWindow& window, std::size_t type)
{
    const app::NodeEditing& nodes = window.session().nodes;
    return nodes.someSelected() && nodes.summary().types[type] == nodes.summary().selected;
}

void take(const app::NodeStep& step, MainWindow& window)
{
    window.canvas().endGesture();
    app::NodeEditing& nodes = window.session().nodes;
    if (!nodes.refusal(step).isEmpty() || !nodes.asksTolerance(step)) {
        nodes.run(step);
        return;
    }
    auto* dialog = new JoinDialog(window.session(), step, &window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &JoinDialog::joined, &window, [&window](const QString& done) {
        window.tell({Message::Kind::Done, done});
    });
    dialog->open();
}

/// The row of a step of the catalogue.
ActionInfo nodeStep(std::size_t number, const QKeySequence& shortcut)
{
    const app::NodeStep& step = app::nodeSteps()[number];
    ActionInfo row{
        .key = step.key,
        .text = step.name,
        .scope = ShortcutScope::Canvas,
        .icon = step.key,
        .run = [&step](MainWindow& w) { take(step, w); },
        .refusal = [&step](const MainWindow& w) { return w.session().nodes.refusal(step); },
        .made = [](MainWindow& w, QAction& action) { w.optionBar().addNodeStep(action); },
    };
    if (!shortcut.isEmpty())
        row.keys = {shortcut};
    row.paletteOnly = step.key == "delete-nodes"; // Edit > Delete deletes them, too
    if (number < types)
        row.checked = [number](const MainWindow& w) { return hasType(w, number); };
    return row;
}

} // namespace

std::vector<ActionInfo> pathRows()
{
    // In the order of the steps. The key of Edit > Delete deletes nodes, too.
    struct Row {
        const char* shortcut;
        bool beginsGroup = false;
    };
    const std::array shortcuts{
        Row{"Shift+C"}, Row{"Shift+S"},   Row{"Shift+Y"}, Row{"Shift+L", true},
        Row{"Shift+U"}, Row{"Ins", true}, Row{""},        Row{"Shift+B", true},
        Row{"Shift+J"}, Row{""},          Row{""},        Row{"Shift+R"}};
    std::vector<ActionInfo> rows;
    for (std::size_t i = 0; i < app::nodeSteps().size(); ++i) {
        const Row row = i < shortcuts.size() ? shortcuts[i] : Row{""};
        if (row.beginsGroup)
            rows.emplace_back(); // a separator
        rows.push_back(nodeStep(i, QKeySequence(row.shortcut)));
    }
    rows.emplace_back(); // a separator
    rows.push_back({
        .key = "stroke-outline",
        .text = Text::tr("Outline of stro&ke"),
        .keys = {QKeySequence("Ctrl+Alt+C")},
        .run = [](MainWindow& w) { w.files().outlineStrokes(); },
        .refusal = [](const MainWindow& w) { return app::outlineRefusal(w.session()); },
    });
    return rows;
}

ActionInfo convertRow()
{
    return {
        .key = "convert-to-path",
        .text = Text::tr("Con&vert to path"),
        .keys = {QKeySequence("Ctrl+Shift+P")},
        .run =
            [](MainWindow& w) {
                w.canvas().endGesture();
                app::convertToPaths(w.session());
            },
        .refusal = [](const MainWindow& w) { return app::convertRefusal(w.session()); },
    };
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_steps.h"
#include "ui/menus/object_rows.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>

namespace ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("ObjectMenu", text); }

/// The row of a step of the catalogue.
ActionInfo nodeStep(const app::NodeStep& step, const QKeySequence& shortcut)
{
    return {
        .key = step.key,
        .text = step.name,
        .keys = shortcut.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{shortcut},
        .scope = ShortcutScope::Canvas,
        .run =
            [&step](MainWindow& w) {
                w.canvas().endGesture();
                w.session().nodes.run(step);
            },
        .submenu = tr("&Path"),
        .refusal = [&step](const MainWindow& w) { return w.session().nodes.refusal(step); },
    };
}

} // namespace

std::vector<ActionInfo> pathRows()
{
    // In the order of the steps; the key of Edit > Delete deletes nodes, too.
    const std::array shortcuts{"Shift+C", "Shift+S", "Shift+Y", "Shift+L", "Shift+U", "Ins",
                               "",        "Shift+B", "Shift+J", "",        "",        "Shift+R"};
    const auto steps = app::nodeSteps();
    std::vector<ActionInfo> rows;
    for (std::size_t i = 0; i < steps.size(); ++i)
        rows.push_back(nodeStep(steps[i], QKeySequence(i < shortcuts.size() ? shortcuts[i] : "")));
    return rows;
}

} // namespace ui

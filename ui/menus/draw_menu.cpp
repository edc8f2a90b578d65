// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/text.h"
#include "ui/menus/actions.h"
#include "ui/tools/tool.h"
#include "ui/window/main_window.h"

#include <QMenu>

namespace ui {

namespace {

/// Adds the tools, grouped as in their catalogue.
void addTools(MainWindow& window, QMenu& menu)
{
    const QList<QAction*> actions = window.toolActions();
    for (qsizetype i = 0; i < actions.size(); ++i) {
        if (tools()[std::size_t(i)].group == ToolInfo::Group::New)
            menu.addSeparator();
        menu.addAction(actions[i]);
    }
}

} // namespace

MenuInfo drawMenu() { return {.title = Text::tr("&Draw"), .begin = addTools}; }

} // namespace ui

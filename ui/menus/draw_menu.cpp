// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/actions.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>
#include <QMenu>

namespace ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("DrawMenu", text); }

} // namespace

/// The Draw menu: the tools, from their own catalogue.
MenuInfo drawMenu()
{
    return {tr("&Draw"), {}, [](MainWindow& window, QMenu& menu) {
                for (QAction* tool : window.toolActions()) {
                    if (tool->property("newGroup").toBool())
                        menu.addSeparator();
                    menu.addAction(tool);
                }
            }};
}

} // namespace ui

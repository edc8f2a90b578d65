// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/commands.h"

#include <QMenu>
#include <QMenuBar>

namespace ui {

namespace {

void add(const QWidget& menu, QList<QAction*>& all)
{
    for (QAction* action : menu.actions())
        if (action->menu())
            add(*action->menu(), all);
        else if (!action->isSeparator())
            all << action;
}

} // namespace

QList<QAction*> commands(const QMenuBar& menus)
{
    QList<QAction*> all;
    add(menus, all);
    return all;
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/actions.h"

#include "app/base/latin.h"
#include "ui/look/look_icon.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

#include <array>
#include <map>

namespace ui {

// Each is defined in the file of its menu.
MenuInfo fileMenu();
MenuInfo editMenu();
MenuInfo viewMenu();
MenuInfo drawMenu();
MenuInfo clipMenu();
MenuInfo compareMenu();
MenuInfo learnMenu();
MenuInfo settingsMenu();
MenuInfo helpMenu();

// THE CATALOGUE. To add a command: add its row in the file of its menu.
std::span<const MenuInfo> menus()
{
    static const std::array all{fileMenu(),    editMenu(),  viewMenu(),     drawMenu(), clipMenu(),
                                compareMenu(), learnMenu(), settingsMenu(), helpMenu()};
    return all;
}

namespace {

QAction* makeAction(MainWindow& window, const ActionInfo& row)
{
    auto* action = new QAction(row.text, &window);
    action->setObjectName(app::latin(row.key));
    action->setShortcuts(row.keys);
    if (!row.icon.empty())
        action->setIcon(icon(row.icon));
    if (row.reach == Reach::Canvas) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        window.canvas().addAction(action);
    }
    action->setCheckable(row.checked != nullptr);
    QObject::connect(action, &QAction::triggered, &window, [&window, run = row.run] {
        run(window);
        window.refreshActions();
    });
    const auto refresh = [action, &row, &window] {
        action->setEnabled(!row.enabled || row.enabled(window));
        action->setStatusTip(action->isEnabled() ? QString() : row.needs);
        if (row.checked)
            action->setChecked(row.checked(window));
    };
    QObject::connect(&window, &MainWindow::actionsOutdated, action, refresh);
    return action;
}

} // namespace

void addMenus(MainWindow& window)
{
    std::map<std::string_view, QActionGroup*> groups;
    for (const MenuInfo& info : menus()) {
        QMenu* menu = window.menuBar()->addMenu(info.title);
        for (const ActionInfo& row : info.rows)
            if (row.key.empty()) {
                menu->addSeparator();
            } else {
                QAction* action = makeAction(window, row);
                menu->addAction(action);
                if (!row.group.empty())
                    groups.try_emplace(row.group, new QActionGroup(&window))
                        .first->second->addAction(action);
            }
        if (info.complete)
            info.complete(window, *menu);
    }
}

QList<QKeySequence> keys(QKeySequence::StandardKey standard, const QList<QKeySequence>& further)
{
    QList<QKeySequence> all = QKeySequence::keyBindings(standard);
    for (const QKeySequence& key : further)
        if (!all.contains(key))
            all << key;
    return all;
}

} // namespace ui

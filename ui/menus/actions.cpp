// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/actions.h"

#include "app/base/keys_in_use.h"
#include "app/base/text.h"
#include "ui/look/look_icon.h"
#include "ui/menus/context_menus.h"
#include "ui/menus/further_commands.h"
#include "ui/menus/other_windows.h"
#include "ui/sheets/command_keys.h"
#include "ui/window/keyboard.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QEvent>
#include <QMenu>
#include <QMenuBar>

#include <array>
#include <map>

namespace ui {

// Each is defined in the file of its menu.
MenuInfo fileMenu();
MenuInfo editMenu();
MenuInfo viewMenu();
MenuInfo objectMenu();
MenuInfo clipMenu();
MenuInfo compareMenu();
MenuInfo learnMenu();
MenuInfo helpMenu();

// THE CATALOGUE. To add a command: add its row in the file of its menu.
std::span<const MenuInfo> menus()
{
    static const std::array all{fileMenu(), editMenu(),    viewMenu(),  objectMenu(),
                                clipMenu(), compareMenu(), learnMenu(), helpMenu()};
    return all;
}

namespace {

QAction* makeAction(MainWindow& window, OtherWindows& others, const ActionInfo& row, bool ofDrawing)
{
    ofDrawing = ofDrawing && !row.show;
    auto* action = new QAction(row.text, &window);
    action->setObjectName(app::latin(row.key));
    action->setShortcuts(row.keys);
    if (!row.icon.empty())
        action->setIcon(icon(row.icon));
    if (row.scope == ShortcutScope::Canvas) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        window.canvas().addAction(action);
    }
    if (row.scope == ShortcutScope::Shown)
        action->setShortcutContext(Qt::WidgetShortcut); // of menus, which never have the focus
    action->setCheckable(bool(row.checked));
    QObject::connect(action, &QAction::triggered, &window, [&window, &others, &row] {
        if (row.show)
            (others.*row.show)();
        else
            row.run(window);
        window.refreshActions();
    });
    action->setProperty(worksInPreview, !ofDrawing);
    const auto refresh = [action, &row, &window, ofDrawing] {
        const QString why = ofDrawing && window.isPreviewing()
                                ? app::Text::tr("Close the preview first (Esc).")
                            : row.refusal ? row.refusal(window)
                                          : QString();
        action->setEnabled(why.isEmpty() && (!row.enabled || row.enabled(window)));
        const QString needed = row.refusal || !why.isEmpty() ? why : app::withKeys(row.needs);
        action->setStatusTip(action->isEnabled() ? QString() : needed);
        if (row.refusal)
            action->setToolTip(needed);
        if (row.checked)
            action->setChecked(row.checked(window));
    };
    QObject::connect(&window, &MainWindow::actionsOutdated, action, refresh);
    if (row.made)
        row.made(window, *action);
    return action;
}

using Groups = std::map<std::string_view, QActionGroup*>;

void addRow(MainWindow& window, OtherWindows& others, const ActionInfo& row, QMenu& menu,
            Groups& groups, bool ofDrawing)
{
    if (row.text.isEmpty()) {
        menu.addSeparator();
    } else if (!row.tool.empty()) {
        menu.addAction(window.toolAction(row.tool));
    } else if (row.fill) {
        row.fill(window, row.submenu.isEmpty() ? *menu.addMenu(row.text) : menu);
    } else {
        QAction* action = makeAction(window, others, row, ofDrawing);
        menu.addAction(action);
        if (row.group.empty())
            return;
        QActionGroup*& group = groups[row.group];
        if (!group)
            group = new QActionGroup(&window);
        group->addAction(action);
    }
}

QMenu* addSubmenu(QMenu& menu, const QString& title)
{
    QMenu* submenu = menu.addMenu(title);
    submenu->setToolTipsVisible(true); // which say why commands are disabled
    return submenu;
}

/// The place of a command without an entry, named as its entry would be.
QMenu& furtherMenu(MainWindow& window, const QString& menu, const QString& submenu)
{
    const auto in = [](QMenu& above, const QString& title) -> QMenu& {
        for (const QAction* action : above.actions())
            if (action->menu() && action->text() == title)
                return *action->menu();
        return *above.addMenu(title);
    };
    QMenu& first = in(furtherCommands(window), menu);
    return submenu.isEmpty() ? first : in(first, submenu);
}

} // namespace

void addMenus(MainWindow& window)
{
    auto* others = new OtherWindows(window);
    Groups groups;
    for (const MenuInfo& info : menus()) {
        QMenu* menu = window.menuBar()->addMenu(info.title);
        if (info.begin)
            info.begin(window, *menu);
        QMenu* submenu = nullptr; // of the row before
        for (const ActionInfo& row : info.rows) {
            if (row.paletteOnly) {
                QMenu& further = furtherMenu(window, info.title, row.submenu);
                addRow(window, *others, row, further, groups, info.ofDrawing);
                for (QAction* action : further.actions())
                    if (action->shortcutContext() == Qt::WindowShortcut && !action->menu())
                        window.addAction(action); // its keys work, although the menu is not shown
                continue;
            }
            if (row.submenu.isEmpty())
                submenu = nullptr;
            else if (!submenu || submenu->title() != row.submenu)
                submenu = addSubmenu(*menu, row.submenu);
            addRow(window, *others, row, submenu ? *submenu : *menu, groups, info.ofDrawing);
        }
    }
    addSettingCommands(window);
    new CommandKeys(window);
    addContextMenus(window);
    qApp->installEventFilter(new MenuKeys(&window));
    window.refreshActions();
}

QList<QKeySequence> keys(QKeySequence::StandardKey standard, const QList<QKeySequence>& further)
{
    QList<QKeySequence> all = QKeySequence::keyBindings(standard);
    for (const QKeySequence& key : further)
        if (!all.contains(key))
            all << key;
    return all;
}

bool MenuKeys::eventFilter(QObject* receiver, QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride
        || !qobject_cast<QMenu*>(QApplication::activePopupWidget()))
        return QObject::eventFilter(receiver, event);
    event->accept();
    return true;
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/command_keys.h"

#include "app/base/text.h"
#include "ui/files/files.h"
#include "ui/look/key_tip.h"
#include "ui/look/text.h"
#include "ui/window/keyboard.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QSettings>

namespace ui {

namespace {

QString withoutLetter(QString text) { return text.remove(u'&').remove(u'…'); }

/// Empty: it has no name of its own, such as a recent file.
QString keyOf(const QAction& action)
{
    if (const auto* panel = qobject_cast<const QDockWidget*>(action.parent()))
        return QStringLiteral("panel-") + panel->objectName();
    return action.objectName();
}

app::KeyedCommand::Scope scopeOf(const QAction& action)
{
    using enum app::KeyedCommand::Scope;
    return action.shortcutContext() == Qt::WidgetShortcut               ? ChosenWindow
           : action.shortcutContext() == Qt::WidgetWithChildrenShortcut ? Canvas
                                                                        : Everywhere;
}

struct Commands {
    std::vector<QAction*> actions;
    std::vector<app::KeyedCommand> rows;
};

void add(const QWidget& menu, const QString& title, Commands& all)
{
    for (QAction* action : menu.actions()) {
        const QString name = withoutLetter(action->text());
        if (action->menu()) {
            add(*action->menu(), title.isEmpty() ? name : title + QStringLiteral(" › ") + name,
                all);
        } else if (!action->isSeparator() && !keyOf(*action).isEmpty()) {
            all.actions.push_back(action);
            all.rows.push_back(
                {keyOf(*action), name, title, scopeOf(*action), action->shortcuts()});
        }
    }
}

/// Every command with a name, and the letters that open menus.
Commands commandsOf(MainWindow& window)
{
    Commands all;
    add(*window.menuBar(), {}, all);
    add(furtherCommands(window), {}, all);
    for (const QAction* menu : window.menuBar()->actions()) {
        all.actions.push_back(nullptr);
        all.rows.push_back({{},
                            Text::tr("the menu %1").arg(withoutLetter(menu->text())),
                            {},
                            app::KeyedCommand::Scope::Fixed,
                            {QKeySequence::mnemonic(menu->text())}});
    }
    return all;
}

} // namespace

CommandKeys::CommandKeys(MainWindow& window) : QObject(&window), window_(window), table_({})
{
    Commands all = commandsOf(window);
    actions_ = std::move(all.actions);
    table_ = app::KeyTable(std::move(all.rows), QSettings().value("shortcuts").toStringList());
    apply();
}

void CommandKeys::reread()
{
    const QStringList saved = QSettings().value("shortcuts").toStringList();
    if (saved == table_.saved())
        return;
    table_ = app::KeyTable(table_.commands(), saved);
    apply();
}

void CommandKeys::tellIgnored()
{
    if (table_.ignored() == 0)
        return;
    const auto tell = [this] {
        if (!window_.message().isEmpty())
            return;
        window_.tell({Message::Kind::Warning,
                      Text::tr("Some keyboard shortcuts in the settings could not be used and were "
                               "ignored.")});
        disconnect(afterLoading_);
    };
    // The message of a file that was opened is not replaced; one without a message comes later.
    afterLoading_ = connect(&window_.files(), &Files::told, this, tell, Qt::QueuedConnection);
    window_.files().whenIdle([self = QPointer(this), tell] {
        if (self)
            tell();
    });
}

CommandKeys& CommandKeys::of(MainWindow& window)
{
    return *window.findChild<CommandKeys*>(QString(), Qt::FindDirectChildrenOnly);
}

void CommandKeys::change(const std::function<void(app::KeyTable&)>& step)
{
    step(table_);
    apply();
    QSettings().setValue("shortcuts", table_.saved());
}

void CommandKeys::apply()
{
    for (std::size_t i = 0; i < actions_.size(); ++i)
        if (actions_[i] && actions_[i]->shortcuts() != table_.keys(i))
            actions_[i]->setShortcuts(table_.keys(i));
    app::KeysInUse keys;
    QHash<QString, QList<QKeySequence>> all;
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        all[table_.commands()[i].key] = table_.keys(i);
        if (!table_.keys(i).isEmpty())
            keys[table_.commands()[i].key] =
                table_.keys(i).front().toString(QKeySequence::NativeText);
    }
    window_.canvas().leaveKeysToCommands(all);
    KeyNews::get().tell(keys);
    window_.refreshActions(); // their reasons name keys
}

} // namespace ui

#include "moc_command_keys.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/showing/shown_commands.h"

#include "app/teaching/shown_steps.h"
#include "ui/look/text.h"
#include "ui/sheets/command_keys.h"
#include "ui/window/keyboard.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>

#include <algorithm>

namespace ui {

namespace {

bool contains(const QWidget& menu, const QAction* action)
{
    return std::ranges::any_of(menu.actions(), [action](const QAction* one) {
        return one == action || (one->menu() && contains(*one->menu(), action));
    });
}

const app::KeyedCommand* infoOf(const MainWindow& window, const QString& key)
{
    const auto& all = CommandKeys::of(const_cast<MainWindow&>(window)).table().commands();
    const auto found = std::ranges::find(all, key, &app::KeyedCommand::key);
    return found == all.end() ? nullptr : &*found;
}

} // namespace

QAction* commandWith(MainWindow& window, const QWidget& receiver, const QKeySequence& keys)
{
    const bool onCanvas = window.canvas().isAncestorOf(&receiver);
    for (QAction* action : commands(window)) {
        const Qt::ShortcutContext where = action->shortcutContext();
        if (action->isEnabled() && action->shortcuts().contains(keys) && where != Qt::WidgetShortcut
            && (onCanvas || where != Qt::WidgetWithChildrenShortcut))
            return action;
    }
    return nullptr;
}

bool mayBeShown(MainWindow& window, const QAction& command)
{
    static const QStringList leaves{"cut",
                                    "copy",
                                    "copy-style",
                                    "find-command",
                                    "hard-cases",
                                    "judge",
                                    "reproduce-paper",
                                    "agree",
                                    "export-steps",
                                    "full-screen",
                                    "presentation",
                                    "reset-layout",
                                    "about-algorithm",
                                    "next-drawing",
                                    "previous-drawing",
                                    "reopen"};
    static const QStringList menus{Text::tr("&File"), Text::tr("&Help")};
    const QString key = command.objectName();
    if (key == QStringLiteral("page"))
        return true;
    if (leaves.contains(key) || key.startsWith(QStringLiteral("theme-")))
        return false;
    for (const QWidget* all :
         {static_cast<QWidget*>(window.menuBar()), static_cast<QWidget*>(&furtherCommands(window))})
        for (const QAction* menu : all->actions())
            if (menu->menu() && contains(*menu->menu(), &command))
                return !menus.contains(menu->text()) && menu->text() != Text::tr("Settings");
    return false;
}

QAction* commandToShow(MainWindow& window, const QString& key)
{
    for (QAction* action : commands(window))
        if (!key.isEmpty() && action->objectName() == key)
            return mayBeShown(window, *action) ? action : nullptr;
    return nullptr;
}

QString wordsFor(const MainWindow& window, const app::ShownStep& step)
{
    using Kind = app::ShownStep::Kind;
    if (step.kind == Kind::Command) {
        const app::KeyedCommand* info = infoOf(window, step.command);
        const auto* action = window.findChild<QAction*>(step.command);
        const QString name =
            step.sentence.isEmpty() ? info ? info->name : step.command : step.sentence;
        const QString key =
            action ? action->shortcut().toString(QKeySequence::NativeText) : QString();
        return key.isEmpty() ? name : Text::tr("%1 (%2)").arg(name, key);
    }
    if (step.kind == Kind::Press && step.sentence.isEmpty())
        return Text::tr("Press %1").arg(step.button);
    if (step.kind == Kind::Type)
        return step.sentence.isEmpty() ? Text::tr("Type %1").arg(step.typed)
                                       : Text::tr("%1: %2").arg(step.sentence, step.typed);
    if (!step.sentence.isEmpty())
        return step.sentence;
    return step.kind == Kind::Drag          ? Text::tr("Drag")
           : step.kind == Kind::DoubleClick ? Text::tr("Double click")
           : step.kind == Kind::Click       ? Text::tr("Click")
                                            : Text::tr("Move the pointer");
}

} // namespace ui

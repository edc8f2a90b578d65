// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/further_commands.h"

#include "ui/look/text.h"
#include "ui/sheets/setting.h"
#include "ui/window/keyboard.h"
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QMenu>

namespace ui {

namespace {

/// A command that sets a setting to `value`; for one that is on or off, -1: to the other.
QAction* addCommand(MainWindow& window, QMenu& menu, const Setting& setting, const QString& key,
                    const QString& text, int value)
{
    auto* action = menu.addAction(text);
    action->setObjectName(key);
    action->setCheckable(true);
    window.addAction(action); // its keys work, although the menu is never shown
    QObject::connect(action, &QAction::triggered, &window, [&window, &setting, value] {
        change(setting, window, value < 0 ? 1 - setting.value(window) : value);
    });
    const auto follow = [&window, &setting, action, value] {
        action->setChecked(setting.value(window) == (value < 0 ? 1 : value));
    };
    QObject::connect(&window, &MainWindow::actionsOutdated, action, follow);
    return action;
}

void addSettingTo(MainWindow& window, QMenu& menu, const Setting& setting)
{
    if (setting.choices.empty()) {
        addCommand(window, menu, setting, setting.key,
                   setting.command.isEmpty() ? setting.text : setting.command, -1);
        return;
    }
    QMenu& choices = *menu.addMenu(setting.text);
    auto* group = new QActionGroup(&choices);
    for (std::size_t i = 0; i < setting.choices.size(); ++i)
        group->addAction(addCommand(window, choices, setting, setting.choices[i].key,
                                    setting.choices[i].text, int(i)));
}

} // namespace

void addSettingCommands(MainWindow& window)
{
    QMenu& menu = *furtherCommands(window).addMenu(Text::tr("Settings"));
    for (const SettingsGroup& group : settingsGroups())
        for (const Setting& setting : group.settings)
            if (setting.isOnlyHere)
                addSettingTo(window, menu, setting);
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "ui/editing/editing.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/widgets/unit_box.h"
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QMenu>

#include <algorithm>
#include <array>

namespace ui {

namespace {

/// Marks the first letter that no earlier entry has: p of pt, x of px.
QString withLetter(QString name, QString& taken)
{
    const auto isFree = [&taken](QChar letter) { return !taken.contains(letter); };
    const auto letter = std::ranges::find_if(name, isFree);
    if (letter == name.end())
        return name;
    taken += *letter;
    return name.insert(letter - name.begin(), u'&');
}

void addUnits(MainWindow& window, QMenu& menu)
{
    auto* group = new QActionGroup(&menu);
    QString taken;
    for (const app::Unit unit : shownUnits()) {
        const auto suffix = app::infoOf(unit).suffix;
        auto* action =
            menu.addAction(withLetter(app::latin(suffix), taken), &window, [&window, unit] {
                window.session().changeDisplay(
                    [unit](app::Display& display) { display.unit = unit; });
            });
        action->setObjectName(QStringLiteral("unit-") + app::latin(suffix));
        action->setCheckable(true);
        group->addAction(action);
        QObject::connect(&window, &MainWindow::actionsOutdated, action, [&window, unit, action] {
            action->setChecked(window.session().display().unit == unit);
        });
    }
}

struct UndoMemory {
    const char* text;
    int megabytes;
};
constexpr std::array undoMemories{UndoMemory{QT_TRANSLATE_NOOP("Text", "&250 MB"), 250},
                                  UndoMemory{QT_TRANSLATE_NOOP("Text", "&1 GB"), 1000},
                                  UndoMemory{QT_TRANSLATE_NOOP("Text", "&4 GB"), 4000},
                                  UndoMemory{QT_TRANSLATE_NOOP("Text", "1&6 GB"), 16000}};

/// When the steps to undo need more, the oldest ones go.
void addUndoMemories(MainWindow& window, QMenu& menu)
{
    auto* group = new QActionGroup(&menu);
    for (const UndoMemory& memory : undoMemories) {
        auto* action =
            menu.addAction(Text::tr(memory.text), &window, [&window, megabytes = memory.megabytes] {
                setUndoMegabytes(megabytes);
                window.session().history.setLimit(bytesOf(megabytes));
            });
        action->setObjectName(QStringLiteral("undo-memory"));
        action->setCheckable(true);
        action->setChecked(undoMegabytes() == memory.megabytes);
        group->addAction(action);
    }
}

void addSettings(MainWindow& window, QMenu& menu)
{
    addUnits(window, *menu.addMenu(Text::tr("&Units")));
    addUndoMemories(window, *menu.addMenu(Text::tr("&Memory for undo")));
}

} // namespace

ActionInfo settingsRow() { return {.text = Text::tr("Se&ttings"), .fill = addSettings}; }

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/keyboard.h"

#include <QKeyEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include <array>
#include <string_view>

namespace ui {

namespace {

/// A row of keys from left to right, and the scan code of the first. XKB's codes are Linux's plus
/// 8.
struct Row {
    quint32 first;
    std::string_view keys;
    constexpr bool contains(quint32 code) const
    {
        return code >= first && code < first + keys.size();
    }
};
constexpr std::array rows{Row{10, "1234567890"}, Row{24, "QWERTYUIOP"}, Row{38, "ASDFGHJKL"},
                          Row{52, "ZXCVBNM"}};

bool isLatin(int key)
{
    return (key >= Qt::Key_A && key <= Qt::Key_Z) || (key >= Qt::Key_0 && key <= Qt::Key_9);
}

} // namespace

std::optional<QKeyCombination> keyAtItsPlace(const QKeyEvent& event)
{
    // In Qt, keys that type a character have codes below those of special keys.
    if (isLatin(event.key()) || event.key() >= Qt::Key_Escape)
        return std::nullopt;
    for (const Row& row : rows)
        if (row.contains(event.nativeScanCode())) {
            const char key = row.keys[event.nativeScanCode() - row.first];
            // A character typed with Shift on a digit key is meant itself.
            const bool digit = key >= '0' && key <= '9';
            if (digit && event.modifiers().testFlag(Qt::ShiftModifier))
                return std::nullopt;
            return QKeyCombination(event.modifiers() & ~Qt::KeypadModifier, Qt::Key(key));
        }
    return std::nullopt;
}

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

QList<QAction*> commands(QMainWindow& window)
{
    QList<QAction*> all;
    add(*window.menuBar(), all);
    add(furtherCommands(window), all);
    return all;
}

QMenu& furtherCommands(QMainWindow& window)
{
    const QString name = QStringLiteral("further-commands");
    if (auto* menu = window.findChild<QMenu*>(name, Qt::FindDirectChildrenOnly))
        return *menu;
    auto* menu = new QMenu(&window);
    menu->setObjectName(name);
    return *menu;
}

} // namespace ui

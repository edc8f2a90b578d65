// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/session/window_steps.h"
#include "ui/docks/window_panel.h"
#include "ui/menus/context_menus.h"
#include "ui/window/main_window.h"

#include <QActionGroup>

#include <array>

namespace ui {
namespace {

// To add a command: add its key.
constexpr std::array<std::string_view, 10> onWindow{
    "crop",         "cut-out", "split",          "", "keep-inside",
    "keep-outside", "",        "window-to-path", "", "remove-window"};

struct OperationRow {
    const char* key;
    const char* text;
};
/// In the order of app::WindowOperation.
constexpr std::array<OperationRow, 3> operations{
    {{"window-adds", QT_TRANSLATE_NOOP("Text", "&Add to those above")},
     {"window-cuts-out", QT_TRANSLATE_NOOP("Text", "Cut out of t&hose above")},
     {"window-intersects", QT_TRANSLATE_NOOP("Text", "Int&ersect with those above")}}};

void addOperations(MainWindow& window, QMenu& menu, QAction* before)
{
    const auto number = window.session().windowNumber();
    if (!number)
        return;
    const int now = int(window.session().windows().list[*number].operation);
    auto* group = new QActionGroup(&menu);
    for (int i = 0; i < int(operations.size()); ++i) {
        auto* action = new QAction(Text::tr(operations[std::size_t(i)].text), group);
        action->setObjectName(operations[std::size_t(i)].key);
        action->setCheckable(true);
        action->setChecked(i == now);
        QObject::connect(action, &QAction::triggered, &window, [&window, number, i] {
            app::setWindowOperation(window.session(), *number, app::WindowOperation(i));
        });
        menu.insertAction(before, action);
    }
    menu.insertSeparator(before);
}

} // namespace

QMenu* windowMenu(MainWindow& window)
{
    QMenu* menu = contextMenu(window, onWindow);
    QAction* const first = menu->actions().value(0);
    addOperations(window, *menu, first);
    auto* rename = new QAction(Text::tr("Re&name…"), menu);
    rename->setObjectName(QStringLiteral("rename-window"));
    QObject::connect(rename, &QAction::triggered, &window, [&window] {
        window.raisePanel(QStringLiteral("window"));
        window.windowPanel().rename();
    });
    menu->insertAction(first, rename);
    menu->insertSeparator(first);
    return menu;
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/latin.h"
#include "ui/actions.h"
#include "ui/main_window.h"
#include "ui/widgets/unit_box.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>

namespace ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("SettingsMenu", text); }

void addUnits(MainWindow& window, QMenu& menu)
{
    auto* group = new QActionGroup(&menu);
    for (const app::Unit unit : shownUnits()) {
        const auto suffix = app::infoOf(unit).suffix;
        auto* action =
            menu.addAction(QStringLiteral("&") + app::latin(suffix), &window, [&window, unit] {
                app::Display display = window.session().display();
                display.unit = unit;
                window.session().setDisplay(display);
            });
        action->setCheckable(true);
        group->addAction(action);
        QObject::connect(&window, &MainWindow::actionsOutdated, action, [&window, unit, action] {
            action->setChecked(window.session().display().unit == unit);
        });
    }
}

} // namespace

MenuInfo settingsMenu()
{
    return {tr("&Settings"), {}, [](MainWindow& window, QMenu& menu) {
                addUnits(window, *menu.addMenu(tr("&Units")));
            }};
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/window_add_menu.h"

#include "app/base/text.h"
#include "app/session/window_kinds.h"
#include "app/session/window_places.h"
#include "app/session/window_steps.h"
#include "ui/dialogs/margin_dialog.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QMenu>

namespace ui {
namespace {

void addShapes(app::Session& session, QMenu& menu)
{
    for (const app::WindowKind& kind : app::windowKinds()) {
        if (!kind.make)
            continue;
        const QString name = Text::tr(kind.name.data());
        menu.addAction(icon(kind.key), name, &menu, [&session, &kind] {
            const clipping::Window page = session.now().page().rectangle();
            const auto quarter = (page.max - page.min) * 0.25;
            app::addWindow(session, {.shape = kind.make({page.min + quarter, page.max - quarter})});
        });
    }
}

void addPlaces(app::Session& session, QMenu& menu, QWidget& parent)
{
    for (const app::LayingPlace& place : app::windowPlaces()) {
        const QString text = Text::tr(place.text.data());
        QAction* action =
            menu.addAction(text, &menu, [&session, &place] { app::layWindow(session, place); });
        action->setObjectName(QStringLiteral("add-") + app::latin(place.key));
        QObject::connect(&menu, &QMenu::aboutToShow, action, [&session, &place, action] {
            action->setEnabled(place.box(session).has_value());
        });
    }
    menu.addAction(Text::tr("Lay window inside the page's &margins…"), &menu,
                   [&session, &parent] { MarginDialog::show(session, parent); });
}

} // namespace

QMenu* makeWindowAddMenu(app::Session& session, QWidget& parent)
{
    auto* menu = new QMenu(&parent);
    addShapes(session, *menu);
    menu->addSeparator();
    addPlaces(session, *menu, parent);
    menu->addSeparator();
    QAction* selected = menu->addAction(Text::tr("Selected objects"), menu,
                                        [&session] { app::addWindowsOfSelection(session); });
    QObject::connect(menu, &QMenu::aboutToShow, selected, [&session, selected] {
        selected->setEnabled(!app::windowsOfSelection(session).empty());
    });
    return menu;
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/snap_choice.h"

#include "app/base/text.h"
#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/ticking_menu.h"

#include <QKeyEvent>

namespace ui {

constexpr int arrow = 16; // pixels

SnapChoice::SnapChoice(Canvas& canvas) : canvas_(canvas), menu_(new TickingMenu(this))
{
    setIcon(ui::icon("snap"));
    setIconSize({18, 18});
    setFixedSize(space::toolButton + arrow, space::toolButton);
    setCheckable(true);
    setAutoRaise(true);
    setObjectName(QStringLiteral("snap-choice"));
    setAccessibleName(Text::tr("Snap"));
    setMenu(menu_);
    setPopupMode(QToolButton::MenuButtonPopup);
    setContextMenuPolicy(Qt::CustomContextMenu);
    connect(this, &QWidget::customContextMenuRequested, this, &QToolButton::showMenu);
    addKinds();
    connect(this, &QToolButton::clicked, this, [this](bool on) { canvas_.switchSnapping(on); });
    connect(&canvas, &Canvas::snappingChanged, this, &SnapChoice::follow);
    connect(menu_, &QMenu::aboutToHide, &canvas, [&canvas] { canvas.setFocus(); });
    followKeys(*this, [this] { follow(); });
}

void SnapChoice::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Down && (event->modifiers() & Qt::AltModifier))
        return showMenu();
    QToolButton::keyPressEvent(event);
}

void SnapChoice::addKinds()
{
    for (const app::SnapKind& kind : app::snapKinds()) {
        QAction* action = menu_->addAction(kind.name);
        action->setObjectName(app::latin(kind.key));
        action->setCheckable(true);
        connect(action, &QAction::triggered, this, [this, &kind](bool on) {
            const app::SnapTo now = canvas_.snapping();
            canvas_.setSnapping(on ? now.with(kind.key) : now.without(kind.key));
        });
    }
}

void SnapChoice::follow()
{
    const app::SnapTo now = canvas_.snapping();
    setChecked(canvas_.snaps());
    setToolTip(
        app::withKeys(Text::tr("Snap to places of the drawing ({snap}). Hold Ctrl to suspend it.\n"
                               "%1 of %2 kinds of places are chosen. The arrow, or Alt+Down: "
                               "choose them."))
            .arg(now.size())
            .arg(app::snapKinds().size()));
    for (const app::SnapKind& kind : app::snapKinds())
        menu_->findChild<QAction*>(app::latin(kind.key))->setChecked(now.has(kind));
}

} // namespace ui

#include "moc_snap_choice.cpp"

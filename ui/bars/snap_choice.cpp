// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/snap_choice.h"

#include "app/base/text.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/ticking_menu.h"

#include <QHBoxLayout>

namespace ui {
namespace {

QString countText(std::size_t on, std::size_t all)
{
    return Text::tr("%1 of %2 kinds").arg(on).arg(all);
}

} // namespace

SnapChoice::SnapChoice(Canvas& canvas)
    : canvas_(canvas), switch_(new QToolButton), kinds_(new QToolButton),
      menu_(new TickingMenu(this))
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(switch_);
    row->addWidget(kinds_);
    switch_->setIcon(icon("snap"));
    switch_->setIconSize({18, 18});
    switch_->setFixedSize(space::toolButton, space::toolButton);
    switch_->setCheckable(true);
    switch_->setAutoRaise(true);
    switch_->setAccessibleName(Text::tr("Snap"));
    switch_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(switch_, &QWidget::customContextMenuRequested, this,
            [this](const QPoint& at) { menu_->popup(switch_->mapToGlobal(at)); });
    switch_->setToolTip(Text::tr("Snap to places of the drawing (F5). Hold Ctrl to suspend it."));
    kinds_->setObjectName(QStringLiteral("snap-kinds"));
    kinds_->setProperty("framed", true);
    kinds_->setFixedHeight(space::fieldHeight);
    new RoomForText(*kinds_, countText(10, 10), 36);
    kinds_->setPopupMode(QToolButton::InstantPopup);
    kinds_->setToolTip(Text::tr("Choose the kinds of places to snap to"));
    kinds_->setMenu(menu_);
    addKinds();
    connect(switch_, &QToolButton::clicked, this, [this](bool on) { canvas_.switchSnapping(on); });
    connect(&canvas, &Canvas::snappingChanged, this, &SnapChoice::follow);
    connect(menu_, &QMenu::aboutToHide, &canvas, [&canvas] { canvas.setFocus(); });
    follow();
}

void SnapChoice::showKinds(bool shown) { kinds_->setVisible(shown); }

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
    switch_->setChecked(canvas_.snaps());
    kinds_->setEnabled(canvas_.snaps());
    kinds_->setText(countText(now.size(), app::snapKinds().size()));
    kinds_->setAccessibleName(kinds_->text());
    for (const app::SnapKind& kind : app::snapKinds())
        menu_->findChild<QAction*>(app::latin(kind.key))->setChecked(now.has(kind));
}

} // namespace ui

#include "moc_snap_choice.cpp"

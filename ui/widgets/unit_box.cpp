// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/unit_box.h"

#include "app/base/text.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QMenu>

namespace ui {

std::vector<app::Unit> shownUnits()
{
    using app::Unit;
    return {Unit::Mm, Unit::Cm, Unit::Metre, Unit::Inch, Unit::Foot, Unit::Px, Unit::Pt};
}

UnitButton::UnitButton(app::Session& session, QWidget* parent) : QToolButton(parent)
{
    setAutoRaise(true);
    setFixedHeight(space::fieldHeight);
    setForegroundRole(QPalette::PlaceholderText);
    setToolTip(Text::tr("Unit of lengths"));
    const auto follow = [this, &session] {
        setText(app::latin(app::infoOf(session.display().unit).suffix));
        setAccessibleName(Text::tr("Unit of lengths: %1").arg(text()));
    };
    connect(this, &QToolButton::clicked, this,
            [this, &session] { openUnits(session, *this, mapToGlobal(rect().bottomLeft())); });
    connect(&session, &app::Session::displayChanged, this, follow);
    follow();
}

void openUnits(app::Session& session, QWidget& parent, const QPoint& place)
{
    auto* menu = new QMenu(&parent);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const app::Unit unit : shownUnits()) {
        auto* action =
            menu->addAction(app::latin(app::infoOf(unit).suffix), &session, [&session, unit] {
                session.changeDisplay([unit](app::Display& display) { display.unit = unit; });
            });
        action->setCheckable(true);
        action->setChecked(unit == session.display().unit);
    }
    menu->popup(place);
}

} // namespace ui

#include "moc_unit_box.cpp"

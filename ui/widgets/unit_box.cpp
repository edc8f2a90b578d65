// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/unit_box.h"

#include "app/base/latin.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

namespace ui {

std::vector<app::Unit> shownUnits()
{
    using app::Unit;
    return {Unit::Mm, Unit::Cm, Unit::Inch, Unit::Px, Unit::Pt};
}

UnitBox::UnitBox(app::Session& session, QWidget* parent) : ToolList(parent)
{
    setAccessibleName(Text::tr("Unit"));
    setFixedHeight(space::fieldHeight);
    for (const app::Unit unit : shownUnits()) {
        const auto suffix = app::infoOf(unit).suffix;
        addItem(app::latin(suffix), int(unit));
    }
    const auto follow = [this, &session] {
        setCurrentIndex(findData(int(session.display().unit)));
    };
    connect(this, &QComboBox::activated, this, [this, &session](int index) {
        session.changeDisplay([this, index](app::Display& display) {
            display.unit = app::Unit(itemData(index).toInt());
        });
    });
    connect(&session, &app::Session::displayChanged, this, follow);
    follow();
}

} // namespace ui

#include "moc_unit_box.cpp"

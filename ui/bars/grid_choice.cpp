// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/grid_choice.h"

#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/length_field.h"

#include <QHBoxLayout>

namespace ui {

GridChoice::GridChoice(app::Session& session)
    : session_(session), switch_(new QToolButton),
      spacing_(new LengthField(Text::tr("Grid spacing"), LengthField::Range::NotNegative,
                               LengthField::Suffix::Unit))
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(switch_);
    row->addWidget(spacing_);
    switch_->setIcon(icon("grid"));
    switch_->setIconSize({18, 18});
    switch_->setFixedSize(space::toolButton, space::toolButton);
    switch_->setCheckable(true);
    switch_->setAutoRaise(true);
    switch_->setAccessibleName(Text::tr("Grid"));
    setKeyTip(*switch_, Text::tr("Show the grid, and snap to it ({grid})"));
    spacing_->setToolTip(Text::tr("Grid spacing"));
    new RoomForText(*spacing_, QStringLiteral("000.00 mm"), 28);
    connect(switch_, &QToolButton::clicked, this, [this](bool on) {
        session_.changeDisplay([on](app::Display& display) { display.grid.shown = on; });
    });
    connect(spacing_, &LengthField::edited, this, &GridChoice::setSpacing);
    connect(&session, &app::Session::displayChanged, this, &GridChoice::follow);
    connect(&session.document, &app::EditedDocument::changed, this, &GridChoice::follow);
    follow();
}

void GridChoice::showSpacing(bool shown) { spacing_->setVisible(shown); }

void GridChoice::setSpacing(double length)
{
    const double millimetres = length * session_.now().page().millimetresPerUnit();
    if (millimetres >= app::Grid::least && millimetres <= app::Grid::most)
        session_.changeDisplay([&](app::Display& display) {
            display.grid.shown = true;
            display.grid.spacing = millimetres;
        });
    follow();
}

void GridChoice::follow()
{
    const app::Display& display = session_.display();
    const app::Page& page = session_.now().page();
    const double unit = page.millimetresPerUnit();
    switch_->setChecked(display.grid.shown);
    spacing_->show(display.grid.spacing / unit, display.unit, page.realMillimetresPerUnit());
}

} // namespace ui

#include "moc_grid_choice.cpp"

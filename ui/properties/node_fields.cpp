// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/properties/node_fields.h"

#include "app/base/keys_in_use.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/unit_box.h"

#include <QGridLayout>

#include <array>

namespace ui {
namespace {

constexpr int rowGap = 4, leastNumberWidth = 56;

} // namespace

NodeFields::NodeFields(app::Session& session, QWidget* parent) : QWidget(parent), session_(session)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                             space::labelToField);
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(rowGap);
    const std::array rows{Text::tr("Node"), Text::tr("In"), Text::tr("Out")};
    for (int row = 0; row < int(rows.size()); ++row)
        grid->addWidget(quietLabel(rows[std::size_t(row)]), row, 0);
    for (const app::NodeNumber& number : app::nodeNumbers()) {
        const int i = int(fields_.size()), row = i / 2, column = 1 + i % 2 * 2;
        fields_.push_back(makeField(number));
        QLabel* label = quietLabel(number.label);
        label->setBuddy(fields_.back());
        grid->addWidget(label, row, column);
        grid->addWidget(fields_.back(), row, column + 1);
    }
    grid->addWidget(new UnitButton(session), 0, 5);
    grid->setColumnStretch(2, 1);
    grid->setColumnStretch(4, 1);
    grid->setRowStretch(int(rows.size()), 1);
}

LengthField* NodeFields::makeField(const app::NodeNumber& number)
{
    const bool isAngle = number.quantity == app::Quantity::Angle;
    auto* field =
        new LengthField(number.name, LengthField::Range::Any,
                        isAngle ? LengthField::Suffix::Degrees : LengthField::Suffix::None);
    field->setMinimumWidth(leastNumberWidth);
    connect(field, &LengthField::edited, this, [this, &number](double value, app::Merging merging) {
        app::setNodeNumber(session_, number, value, merging);
        follow(); // a refused number disappears
    });
    connect(field, &LengthField::entered, this, &NodeFields::entered);
    connect(field, &LengthField::refused, this, &NodeFields::refused);
    connect(field, &LengthField::taken, this, &NodeFields::taken);
    return field;
}

void NodeFields::follow()
{
    const double size = session_.now().page().realMillimetresPerUnit();
    const auto numbers = app::nodeNumbers();
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const auto value = app::nodeValue(session_, numbers[i]);
        const bool isAngle = numbers[i].quantity == app::Quantity::Angle;
        const app::Unit unit = isAngle ? app::Unit::User : session_.display().unit;
        const double scale = isAngle ? 1 : size;
        fields_[i]->setEnabled(value.has_value());
        fields_[i]->setToolTip(value ? numbers[i].name : app::withKeys(numbers[i].missing));
        if (value && value->mixed)
            fields_[i]->showMixed(value->first, unit, scale);
        else
            fields_[i]->show(value ? value->first : 0, unit, scale);
        if (!value)
            fields_[i]->showNothing();
    }
}

} // namespace ui

#include "moc_node_fields.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/properties/selection_panel.h"

#include "app/session/units.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/properties/node_fields.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/reference_point.h"
#include "ui/widgets/unit_box.h"

#include <QGridLayout>

namespace ui {
namespace {

constexpr int leastFieldWidth = 56, leastAngleWidth = 43, rowDistance = 4; // pixels

} // namespace

SelectionPanel::SelectionPanel(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), reference_(new ReferencePoint), chain_(ratioButton()),
      nodes_(new NodeFields(session)), pages_(new QStackedLayout(this))
{
    pages_->addWidget(makeObjects());
    pages_->addWidget(nodes_);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &SelectionPanel::follow);
    const auto follow = [this] {
        if (isVisible())
            soon_.start(0);
    };
    connect(&session, &app::Session::selectionChanged, this, follow);
    connect(&session.nodes, &app::NodeEditing::changed, this, follow);
    connect(&session, &app::Session::displayChanged, this, follow);
    connect(&session.document, &app::EditedDocument::changed, this, follow);
    connect(reference_, &ReferencePoint::changed, this, follow);
    connect(nodes_, &NodeFields::entered, this, &SelectionPanel::entered);
    connect(nodes_, &NodeFields::refused, this, &SelectionPanel::refused);
    connect(nodes_, &NodeFields::taken, this, &SelectionPanel::taken);
    this->follow();
}

QWidget* SelectionPanel::makeObjects()
{
    auto* objects = new QWidget;
    auto* column = new QVBoxLayout(objects);
    column->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                               space::labelToField);
    column->setSpacing(rowDistance);
    column->addLayout(makeNumbers());
    return objects;
}

std::pair<QLabel*, LengthField*> SelectionPanel::makeField(const app::SelectionNumber& number)
{
    using Range = LengthField::Range;
    const bool isLength = number.quantity == app::Quantity::Length;
    const bool isAngle = number.quantity == app::Quantity::Angle;
    auto* field =
        new LengthField(number.name, isLength ? Range::NotNegative : Range::Any,
                        isAngle ? LengthField::Suffix::Degrees : LengthField::Suffix::None);
    field->setAlignment(Qt::AlignRight);
    field->setToolTip(number.name);
    field->setMinimumWidth(leastFieldWidth);
    auto* label = new QLabel(number.label);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setBuddy(field);
    label->setToolTip(number.name);
    connect(field, &LengthField::edited, this,
            [this, &number](double value, app::Merging merging) { edit(number, value, merging); });
    connect(field, &LengthField::entered, this, &SelectionPanel::entered);
    connect(field, &LengthField::refused, this, &SelectionPanel::refused);
    connect(field, &LengthField::taken, this, &SelectionPanel::taken);
    fields_.push_back(field);
    return {label, field};
}

/// X over Y and W over H, with what belongs to them; below, angle, skew and length in one row.
QLayout* SelectionPanel::makeNumbers()
{
    constexpr std::size_t ofBox = 4;
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(rowDistance);
    auto* below = new QHBoxLayout;
    below->setSpacing(space::labelToField);
    for (const app::SelectionNumber& number : app::selectionNumbers()) {
        const std::size_t i = fields_.size();
        const auto [label, field] = makeField(number);
        if (i < ofBox) {
            grid->addWidget(label, int(i % 2), int(i / 2) * 2);
            grid->addWidget(field, int(i % 2), int(i / 2) * 2 + 1);
        } else {
            field->setMinimumWidth(leastAngleWidth);
            below->addWidget(label);
            below->addWidget(field, 1);
        }
    }
    grid->addWidget(chain_, 0, 4, Qt::AlignCenter);
    grid->addWidget(new UnitButton(session_), 1, 4, Qt::AlignCenter);
    grid->addWidget(reference_, 0, 5, 2, 1, Qt::AlignCenter);
    grid->addLayout(below, 2, 0, 1, 6);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    return grid;
}

app::SelectionFrame SelectionPanel::frame() const
{
    return {reference_->chosen(), chain_->isChecked()};
}

void SelectionPanel::showEvent(QShowEvent* event)
{
    follow();
    QWidget::showEvent(event);
}

void SelectionPanel::follow()
{
    if (session_.nodes.someSelected()) {
        pages_->setCurrentIndex(Nodes);
        nodes_->follow();
    } else {
        pages_->setCurrentIndex(Objects);
        followObjects();
    }
}

void SelectionPanel::followObjects()
{
    const double size = session_.now().page().realMillimetresPerUnit();
    const auto numbers = app::selectionNumbers();
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const auto value = numbers[i].value(session_, frame());
        const bool isAngle = numbers[i].quantity == app::Quantity::Angle;
        const app::Unit unit = isAngle ? app::Unit::User : session_.display().unit;
        fields_[i]->show(value.value_or(0), unit, isAngle ? 1 : size);
        if (!value)
            fields_[i]->showNothing();
    }
}

void SelectionPanel::edit(const app::SelectionNumber& number, double value, app::Merging merging)
{
    if (const auto error = app::setSelectionNumber(session_, number, frame(), value, merging))
        emit session_.refused(*error);
    soon_.start(0);
}

} // namespace ui

#include "moc_selection_panel.cpp"

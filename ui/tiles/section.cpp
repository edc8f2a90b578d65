// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tiles/section.h"

#include "ui/look/look.h"
#include "ui/widgets/look_label.h"

namespace ui {

Section::Section(const QString& title, QWidget* parent)
    : QWidget(parent), heading_(new Heading(title)), grid_(new QGridLayout)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(heading_);
    column->addLayout(grid_, 1);
    grid_->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                              space::labelToField);
    grid_->setHorizontalSpacing(space::labelToField);
    grid_->setVerticalSpacing(5);
    grid_->setColumnStretch(1, 1);
    grid_->setColumnMinimumWidth(0, 64);
}

QHBoxLayout* Section::addRow(const QString& label, const QList<QWidget*>& fields)
{
    const int row = grid_->rowCount();
    auto* name = quietLabel(label);
    name->setBuddy(fields.front());
    grid_->addWidget(name, row, 0);
    auto* beside = new QHBoxLayout;
    beside->setSpacing(space::labelToField);
    for (QWidget* field : fields)
        beside->addWidget(field);
    beside->addStretch();
    grid_->addLayout(beside, row, 1);
    return beside;
}

void Section::addWide(QWidget* widget) { grid_->addWidget(widget, grid_->rowCount(), 0, 1, 2); }

} // namespace ui

#include "moc_section.cpp"

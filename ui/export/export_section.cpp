// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_section.h"

#include "ui/look/look.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/look_label.h"

namespace ui {

namespace {

constexpr int widthOfNames = 92; // pixels

} // namespace

ExportSection::ExportSection(const QString& title, QWidget* parent)
    : QWidget(parent), title_(new QLabel(title)), grid_(new QGridLayout)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    grid_->setContentsMargins(space::dockMargin, space::dockMargin, space::dockMargin,
                              space::dockMargin);
    grid_->setHorizontalSpacing(space::labelToField);
    grid_->setVerticalSpacing(6);
    grid_->setColumnMinimumWidth(0, widthOfNames);
    grid_->setColumnStretch(1, 1);
    title_->setFont(semiBold(font()));
    grid_->addWidget(title_, 0, 0, 1, 2);
    column->addLayout(grid_);
    column->addWidget(rule(Qt::Horizontal));
}

ExportSection::Row ExportSection::addRow(const QString& name, const QList<QWidget*>& widgets)
{
    const int row = grid_->rowCount();
    auto* beside = new QWidget;
    auto* across = new QHBoxLayout(beside);
    across->setContentsMargins(0, 0, 0, 0);
    across->setSpacing(space::labelToField);
    for (QWidget* widget : widgets)
        across->addWidget(widget);
    across->addStretch();
    auto* label = quietLabel(name);
    label->setBuddy(widgets.front());
    grid_->addWidget(label, row, 0);
    grid_->addWidget(beside, row, 1);
    return {label, beside};
}

void ExportSection::Row::setVisible(bool visible) const
{
    name->setVisible(visible);
    beside->setVisible(visible);
}

} // namespace ui

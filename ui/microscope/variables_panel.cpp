// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/variables_panel.h"

#include "app/teaching/step_variables.h"
#include "ui/look/text.h"
#include "ui/microscope/variable_table.h"
#include "ui/widgets/heading.h"
#include "ui/widgets/link_button.h"

#include <QHeaderView>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

VariablesPanel::VariablesPanel(QWidget* parent)
    : QWidget(parent), heading_(new Heading(Text::tr("Variables"))), link_(linkButton()),
      table_(new VariableTable)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    link_->setObjectName(QStringLiteral("all-variables-link"));
    heading_->add(link_); // before the table, as the focus goes
    column->addWidget(heading_);
    column->addWidget(table_, 1);
    connect(link_, &QToolButton::clicked, this, [this] {
        showsAll_ = !showsAll_;
        showTable();
    });
    showTable();
}

void VariablesPanel::show(const app::TracedLine& tracedLine, const app::Narration& narration,
                          std::size_t step)
{
    ofStep_ = app::stepVariables(tracedLine, narration, step);
    all_ = app::allVariables(tracedLine, narration, step);
    showTable();
}

void VariablesPanel::showTable()
{
    heading_->setRemark(showsAll_ ? QString() : Text::tr("of this step"));
    link_->setText(showsAll_ ? Text::tr("Only this step") : Text::tr("All %1").arg(all_.size()));
    link_->setAccessibleName(showsAll_ ? Text::tr("Only the variables of this step")
                                       : Text::tr("All variables"));
    link_->setVisible(!all_.empty());
    table_->show(showsAll_ ? all_ : ofStep_);
}

QSize VariablesPanel::sizeHint() const
{
    constexpr int most = 6;
    const int rows = most * table_->verticalHeader()->defaultSectionSize();
    return {table_->sizeHint().width(), heading_->sizeHint().height()
                                            + table_->horizontalHeader()->sizeHint().height() + rows
                                            + 2};
}

} // namespace ui

#include "moc_variables_panel.cpp"

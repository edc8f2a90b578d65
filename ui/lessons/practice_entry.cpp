// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/practice_entry.h"

#include "app/practice/plan.h"
#include "app/practice/record.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/segments.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSettings>
#include <QVBoxLayout>

namespace ui {

PracticeEntry::PracticeEntry(const app::Practice& practice, QWidget* parent)
    : QWidget(parent), practice_(practice), algorithm_(new QComboBox),
      form_(new Segments(Text::tr("Form"), {Text::tr("As published"), Text::tr("Corrected")})),
      record_(quietLabel({})), begin_(new QPushButton(Text::tr("Begin"))),
      goOn_(new QPushButton(Text::tr("Go on")))
{
    auto* title = new QLabel(Text::tr("Do it yourself"));
    title->setFont(semiBold(font()));
    auto* about = quietLabel(Text::tr("You play an algorithm on a line: set outcodes, pick edges, "
                                      "place cuts, compute and decide. Each step is checked."));
    about->setWordWrap(true);
    record_->setWordWrap(true);
    algorithm_->setAccessibleName(Text::tr("Algorithm"));
    for (const app::Variant& variant : app::practiceVariants())
        if (variant.form == clipping::Form::Published)
            algorithm_->addItem(app::latin(variant.algorithm->name),
                                app::latin(variant.algorithm->key));
    form_->choose(0);
    begin_->setObjectName(QStringLiteral("begin-practice"));
    begin_->setToolTip(Text::tr("Play this algorithm on a new line"));
    goOn_->setToolTip(Text::tr("Go on with the attempt that you left"));
    for (QPushButton* button : {begin_, goOn_}) {
        button->setAutoDefault(true); // Enter presses it
        button->setMinimumHeight(space::toolButton);
    }
    auto* choice = new QHBoxLayout;
    choice->addWidget(algorithm_, 1);
    choice->addWidget(form_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(begin_);
    buttons->addWidget(goOn_);
    buttons->addStretch();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, space::betweenGroups, 0, 0);
    column->setSpacing(space::labelToField);
    column->addWidget(title);
    column->addWidget(about);
    column->addLayout(choice);
    column->addWidget(record_);
    column->addLayout(buttons);
    connect(algorithm_, &QComboBox::currentIndexChanged, this, &PracticeEntry::refresh);
    connect(form_, &Segments::picked, this, &PracticeEntry::refresh);
    connect(begin_, &QPushButton::clicked, this, [this] { emit chosen(variant()); });
    connect(goOn_, &QPushButton::clicked, this, &PracticeEntry::goOnWanted);
    refresh();
}

app::Variant PracticeEntry::variant() const
{
    return {clipping::findAlgorithm(algorithm_->currentData().toString().toStdString()),
            form_->chosen() == 0 ? clipping::Form::Published : clipping::Form::Corrected};
}

void PracticeEntry::refresh()
{
    const auto record = app::recordOf(QSettings(), variant());
    record_->setText(!record ? Text::tr("Not played yet.")
                     : record->passed
                         ? Text::tr("Passed. Best: %1 % right at the first try.").arg(record->best)
                         : Text::tr("Best: %1 % right at the first try.").arg(record->best));
    goOn_->setVisible(practice_.isOn() && !practice_.atEnd());
}

} // namespace ui

#include "moc_practice_entry.cpp"

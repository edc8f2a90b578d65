// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/progress_row.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/elements.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>

namespace ui {

namespace {

constexpr int barWidth = 180, barHeight = 8, aboveAndBelow = 6; // logical pixels
constexpr int steps = 1000;                                     // of the bar

} // namespace

ProgressRow::ProgressRow(QWidget* parent)
    : QWidget(parent), sentence_(new QLabel), bar_(new QProgressBar),
      cancel_(plainButton(Text::tr("&Cancel"))), row_(new QHBoxLayout(this))
{
    sentence_->setObjectName(QStringLiteral("state"));
    sentence_->setFont(captionFont(sentence_->font()));
    // A long path is cut off.
    sentence_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    bar_->setRange(0, steps);
    bar_->setTextVisible(false);
    bar_->setFixedSize(barWidth, barHeight);
    bar_->setAccessibleName(Text::tr("Progress"));
    keepPlaceWhenHidden(*bar_);
    keepPlaceWhenHidden(*cancel_);
    row_->setContentsMargins(space::betweenGroups, aboveAndBelow, space::betweenGroups,
                             aboveAndBelow);
    row_->setSpacing(space::dockMargin);
    row_->addWidget(sentence_, 1);
    row_->addWidget(bar_);
    row_->addWidget(cancel_);
    connect(cancel_, &QPushButton::clicked, this, &ProgressRow::cancelWanted);
    setWorking(false);
}

void ProgressRow::tell(const QString& sentence) { sentence_->setText(sentence); }

QString ProgressRow::sentence() const { return sentence_->text(); }

void ProgressRow::start() { showProgress(0, Text::tr("Starting…")); }

void ProgressRow::showProgress(double share, const QString& sentence)
{
    bar_->setValue(int(steps * share));
    tell(sentence);
}

void ProgressRow::setWorking(bool working)
{
    bar_->setVisible(working);
    cancel_->setVisible(working);
}

void ProgressRow::addButton(QPushButton* button) { row_->addWidget(button); }

} // namespace ui

#include "moc_progress_row.cpp"

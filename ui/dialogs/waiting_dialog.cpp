// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/waiting_dialog.h"

#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int wholeBar = 1000, leastWidth = 320, barHeight = 8;
constexpr std::chrono::milliseconds repainting{40}; // of a bar of unknown length

} // namespace

WaitingDialog::WaitingDialog(const QString& label, QWidget* window)
    : QDialog(window), bar_(new QProgressBar), cancel_(new QPushButton(Text::tr("Cancel")))
{
    setObjectName(QStringLiteral("waiting"));
    setWindowModality(Qt::ApplicationModal);
    setMinimumWidth(leastWidth);
    auto* text = new QLabel(label);
    text->setTextFormat(Qt::PlainText);
    text->setAlignment(Qt::AlignCenter);
    bar_->setRange(0, 0);
    bar_->setTextVisible(false);
    bar_->setFixedHeight(barHeight);
    bar_->setAccessibleName(Text::tr("Progress"));
    auto* moving = new QTimer(this);
    connect(moving, &QTimer::timeout, bar_, qOverload<>(&QWidget::update));
    moving->start(repainting);
    auto* buttons = new QDialogButtonBox;
    buttons->addButton(cancel_, QDialogButtonBox::RejectRole);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(space::betweenGroups);
    column->addWidget(text);
    column->addWidget(bar_);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &WaitingDialog::reject);
}

void WaitingDialog::showProgress(const app::Progress& progress)
{
    bar_->setRange(0, wholeBar);
    bar_->setValue(int(progress.share * wholeBar));
}

void WaitingDialog::showStopping() { cancel_->setEnabled(false); }

void WaitingDialog::reject()
{
    if (cancel_->isEnabled())
        emit cancelled();
}

} // namespace ui

#include "moc_waiting_dialog.cpp"

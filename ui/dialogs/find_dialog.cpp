// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/find_dialog.h"

#include "app/session/select_alike.h"
#include "ui/look/text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace ui {

FindDialog::FindDialog(app::Session& session, QWidget* parent)
    : QDialog(parent), session_(session), text_(new QLineEdit), result_(new QLabel)
{
    setWindowTitle(Text::tr("Find objects"));
    text_->setObjectName("find");
    text_->setMinimumWidth(260);
    text_->setPlaceholderText(Text::tr("Object, group or layer"));
    auto* buttons = new QDialogButtonBox;
    buttons->addButton(Text::tr("Close"), QDialogButtonBox::RejectRole);
    auto* select = buttons->addButton(Text::tr("&Select"), QDialogButtonBox::AcceptRole);
    select->setDefault(true);
    auto* form = new QFormLayout(this);
    form->setSizeConstraint(QLayout::SetFixedSize);
    form->addRow(Text::tr("&Id or name"), text_);
    form->addRow(QString(), result_);
    form->addRow(buttons);
    result_->setText(Text::tr("Part of a name is enough."));
    text_->setFocus();
    connect(select, &QPushButton::clicked, this, &FindDialog::search);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void FindDialog::search()
{
    const app::ObjectRanges before = session_.selection();
    result_->setText(app::find(session_, text_->text()));
    text_->setFocus();
    text_->selectAll();
    if (session_.selection() != before)
        emit found();
}

} // namespace ui

#include "moc_find_dialog.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/join_dialog.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/length_field.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {

JoinDialog::JoinDialog(app::Session& session, const app::NodeStep& step, QWidget* parent)
    : QDialog(parent), session_(session), step_(step),
      distance_(new LengthField(Text::tr("Largest distance"), LengthField::Range::NotNegative,
                                LengthField::Suffix::Unit)),
      sentence_(new QLabel)
{
    const auto explain = [this] {
        sentence_->setText(
            Text::tr("Two ends this close become one node if their paths have the same "
                     "layer and the same style."));
    };
    explain();
    setWindowTitle(Text::tr("Join ends"));
    setObjectName(QStringLiteral("join-dialog"));
    const app::Page& page = session.now().page();
    const double unit = page.millimetresPerUnit();
    distance_->show(session.arrange.joinWithin / unit, page.paperUnit(session.display().unit),
                    unit);
    connect(distance_, &LengthField::edited, this,
            [this, unit](double length) { session_.arrange.joinWithin = length * unit; });
    connect(distance_, &LengthField::taken, this, explain);
    connect(distance_, &LengthField::refused, sentence_, &QLabel::setText);
    sentence_->setWordWrap(true);
    sentence_->setForegroundRole(QPalette::PlaceholderText);
    auto* form = new QFormLayout;
    form->addRow(Text::tr("&Largest distance"), distance_);
    auto* buttons = new QDialogButtonBox;
    buttons->addButton(Text::tr("Cancel"), QDialogButtonBox::RejectRole);
    buttons->addButton(Text::tr("&Join ends"), QDialogButtonBox::AcceptRole)->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(space::betweenGroups, space::betweenGroups, space::betweenGroups,
                               space::betweenGroups);
    column->setSpacing(space::betweenGroups);
    column->addLayout(form);
    column->addWidget(sentence_);
    column->addWidget(buttons);
    distance_->selectAll(); // a number that is typed at once replaces the last one
}

void JoinDialog::accept()
{
    const auto done = session_.nodes.tried(step_);
    if (!done)
        return sentence_->setText(done.error);
    QDialog::accept();
    emit joined(*done.value);
}

} // namespace ui

#include "moc_join_dialog.cpp"

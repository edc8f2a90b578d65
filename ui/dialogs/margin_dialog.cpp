// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/margin_dialog.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/length_field.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace ui {

namespace {

constexpr double usualMargin = 10; // mm on paper

LengthField* lengthField(const QString& name)
{
    return new LengthField(name, LengthField::Range::Any, LengthField::Suffix::Unit);
}

} // namespace

MarginDialog::MarginDialog(app::Session& session, QWidget* parent)
    : QDialog(parent), session_(session),
      margins_(app::PageMargins::same(usualMargin / session.now().page().millimetresPerUnit())),
      sides_{Side{lengthField(Text::tr("Left")), &app::PageMargins::left},
             Side{lengthField(Text::tr("Top")), &app::PageMargins::top},
             Side{lengthField(Text::tr("Right")), &app::PageMargins::right},
             Side{lengthField(Text::tr("Bottom")), &app::PageMargins::bottom}},
      same_(new QCheckBox(Text::tr("&Same margin on all sides"))), sentence_(new QLabel)
{
    setWindowTitle(Text::tr("Lay window inside margins"));
    setObjectName(QStringLiteral("margin-dialog"));
    same_->setChecked(true);
    connect(same_, &QCheckBox::toggled, this, [this](bool same) {
        if (same)
            take(&app::PageMargins::left, margins_.left);
    });
    sentence_->setForegroundRole(QPalette::PlaceholderText);
    for (const Side& side : sides_) {
        connect(side.field, &LengthField::refused, sentence_, &QLabel::setText);
        connect(side.field, &LengthField::taken, this, &MarginDialog::sayHint);
    }
    auto* buttons = new QDialogButtonBox;
    buttons->addButton(Text::tr("Cancel"), QDialogButtonBox::RejectRole);
    QPushButton* lay = buttons->addButton(Text::tr("&Lay window"), QDialogButtonBox::AcceptRole);
    lay->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(space::betweenGroups, space::betweenGroups, space::betweenGroups,
                               space::betweenGroups);
    column->addLayout(makeFields());
    column->addWidget(same_);
    column->addWidget(sentence_);
    column->addWidget(buttons);
    follow();
}

QGridLayout* MarginDialog::makeFields()
{
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(space::labelToField);
    for (int i = 0; i < int(sides_.size()); ++i) {
        const auto& [field, margin] = sides_[std::size_t(i)];
        auto* label = new QLabel(field->accessibleName());
        label->setBuddy(field);
        grid->addWidget(label, i / 2, 2 * (i % 2));
        grid->addWidget(field, i / 2, 2 * (i % 2) + 1);
        connect(field, &LengthField::edited, this,
                [this, side = margin](double length) { take(side, length); });
    }
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    return grid;
}

void MarginDialog::take(double app::PageMargins::*side, double margin)
{
    margins_.*side = margin;
    if (same_->isChecked())
        margins_ = app::PageMargins::same(margin);
    follow();
}

void MarginDialog::follow()
{
    const app::Page& page = session_.now().page();
    for (const auto& [field, margin] : sides_)
        field->show(margins_.*margin, page.paperUnit(session_.display().unit),
                    page.millimetresPerUnit());
    sayHint();
}

void MarginDialog::sayHint()
{
    sentence_->setText(Text::tr("A negative margin is outside the page."));
}

void MarginDialog::show(app::Session& session, QWidget& parent)
{
    auto* dialog = new MarginDialog(session, parent.window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MarginDialog::accept()
{
    if (const auto refusal = app::layWindowInside(session_, margins_))
        sentence_->setText(*refusal);
    else
        QDialog::accept();
}

} // namespace ui

#include "moc_margin_dialog.cpp"

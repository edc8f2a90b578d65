// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/page_section.h"

#include "ui/look/look.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/refusal_frame.h"

#include <QScopedValueRollback>

namespace ui {

PageSection::PageSection(const QString& title, app::Session& session, app::PageEditing& editing)
    : session_(session), editing_(editing), column_(new QVBoxLayout), refusal_(new LookLabel)
{
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(space::dockMargin, space::dockMargin, space::dockMargin,
                            space::dockMargin);
    all->setSpacing(space::labelToField);
    auto* name = new QLabel(title);
    name->setFont(semiBold(font()));
    all->addWidget(name);
    column_->setSpacing(space::labelToField);
    all->addLayout(column_);
    all->addWidget(refusal_);
    refusal_->setWordWrap(true);
    refusal_->setColour(errorColour);
    refusal_->setObjectName(QStringLiteral("page-refusal"));
    refusal_->hide();
}

QHBoxLayout* PageSection::addRow()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(space::labelToField);
    column_->addLayout(row);
    return row;
}

void PageSection::take(const app::Result<app::Page>& page, QWidget& field)
{
    withdraw();
    if (const auto why = editing_.change(page)) {
        const QScopedValueRollback refusing(refusing_, true);
        follow();
        refuse(field, *why);
    }
}

void PageSection::fill(LengthField& field, double number, app::Unit unit)
{
    if (refusing_ || !field.isBeingTyped())
        field.show(number, unit, 1);
}

void PageSection::listen(LengthField& field)
{
    connect(&field, &LengthField::refused, this,
            [this, &field](const QString& sentence) { refuse(field, sentence); });
    connect(&field, &LengthField::taken, this, &PageSection::withdraw);
    connect(&field, &LengthField::entered, this, [this] {
        if (refusal_->isHidden())
            emit entered();
    });
}

void PageSection::refuse(QWidget& field, const QString& sentence)
{
    withdraw();
    RefusalFrame*& frame = frames_[&field];
    if (!frame) {
        frame = new RefusalFrame(field);
        connect(frame, &RefusalFrame::typed, this, &PageSection::withdraw);
    }
    frame->show();
    frame->raise();
    refusal_->setText(sentence);
    refusal_->show();
}

void PageSection::withdraw()
{
    for (RefusalFrame* frame : std::as_const(frames_))
        frame->hide();
    refusal_->hide();
}

} // namespace ui

#include "moc_page_section.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/heading.h"

#include "ui/look/look.h"
#include "ui/widgets/quiet_label.h"

#include <QHBoxLayout>
#include <QPainter>

namespace ui {

Heading::Heading(const QString& title, QWidget* parent)
    : QWidget(parent), row_(new QHBoxLayout(this)), remark_(quietLabel({}))
{
    auto* name = new QLabel(title);
    name->setFont(semiBold(font()));
    row_->setContentsMargins(space::dockMargin, 0, space::dockMargin, 0);
    row_->setSpacing(space::labelToField);
    row_->addWidget(name);
    row_->addWidget(remark_);
    row_->addStretch();
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void Heading::setRemark(const QString& remark) { remark_->setText(remark); }

void Heading::add(QWidget* widget) { row_->addWidget(widget); }

QSize Heading::sizeHint() const
{
    return {120, std::max(space::dockTitleHeight, fontMetrics().height() + 8)};
}

void Heading::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().window());
}

} // namespace ui

#include "moc_heading.cpp"

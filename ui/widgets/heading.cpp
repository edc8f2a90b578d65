// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/heading.h"

#include "app/comparison/differences_at.h"
#include "app/session/session.h"
#include "app/session/window_words.h"
#include "ui/look/look.h"
#include "ui/widgets/look_label.h"

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

PageCaption::PageCaption(const app::Session& session, Elsewhere elsewhere, QWidget* parent)
    : QLabel(parent), session_(session), elsewhere_(elsewhere)
{
    setFont(captionFont(font()));
    setForegroundRole(QPalette::PlaceholderText);
    setContentsMargins(space::dockMargin, 0, space::dockMargin, 0);
    setWordWrap(true);
    connect(&session, &app::Session::previewChanged, this, &PageCaption::follow);
    follow();
}

void PageCaption::follow()
{
    setText(elsewhere_ == Elsewhere::AtThePage ? app::atText(session_.compared())
                                               : app::comparedText(session_));
    setHidden(text().isEmpty());
}

} // namespace ui

#include "moc_heading.cpp"

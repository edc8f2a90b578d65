// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/sheet.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/heading.h"

#include <QKeyEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

constexpr int headingHeight = 34, sheetWidth = 360, wideSheet = 420, narrowWidth = 320; // pixels
constexpr int narrowWindow = 1100; ///< a narrower one has narrow sheets

void inColourOfPanels(QWidget& part)
{
    part.setBackgroundRole(QPalette::Button);
    part.setAutoFillBackground(true);
}

QVBoxLayout* plainColumn(QWidget* around)
{
    auto* column = new QVBoxLayout(around);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    return column;
}

} // namespace

Sheet::Sheet(const QString& key, const QString& title, Width width, QWidget* parent)
    : QWidget(parent), width_(width)
{
    setObjectName(key);
    setAccessibleName(title);
    inColourOfPanels(*this);
    auto* across = new QHBoxLayout(this);
    across->setContentsMargins(0, 0, 0, 0);
    across->setSpacing(0);
    across->addWidget(rule(Qt::Vertical));
    auto* page = new QWidget;
    across->addWidget(page, 1);
    auto* column = plainColumn(page);
    addHeading(*column, title);
    addBody(*column);
    addFoot(*column);
}

void Sheet::addHeading(QVBoxLayout& column, const QString& title)
{
    heading_ = new Heading(title);
    heading_->setFixedHeight(headingHeight);
    auto* close = iconButton("close", Text::tr("Close this panel (Esc)"));
    close->setObjectName(QStringLiteral("close-sheet"));
    close->setFocusPolicy(Qt::TabFocus);
    heading_->add(close);
    connect(close, &QToolButton::clicked, this, &Sheet::leave);
    column.addWidget(heading_);
    column.addWidget(rule(Qt::Horizontal));
}

void Sheet::addBody(QVBoxLayout& column)
{
    inner_ = new QWidget;
    inColourOfPanels(*inner_);
    body_ = plainColumn(inner_);
    auto* scrolled = new QScrollArea;
    scrolled->setWidget(inner_);
    scrolled->setWidgetResizable(true);
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolled->setFocusPolicy(Qt::NoFocus);
    inColourOfPanels(*scrolled->viewport());
    column.addWidget(scrolled, 1);
}

void Sheet::addFoot(QVBoxLayout& column)
{
    column.addWidget(rule(Qt::Horizontal));
    aboveButtons_ = new QVBoxLayout;
    aboveButtons_->setSpacing(space::labelToField);
    foot_ = new QHBoxLayout;
    foot_->setSpacing(space::labelToField);
    foot_->addStretch();
    auto* foot = new QVBoxLayout;
    foot->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                             space::labelToField);
    foot->setSpacing(space::labelToField);
    foot->addLayout(aboveButtons_);
    foot->addLayout(foot_);
    column.addLayout(foot);
}

void Sheet::setRemark(const QString& remark) { heading_->setRemark(remark); }

void Sheet::addToFoot(QPushButton* button, Side side)
{
    side == Side::Right ? foot_->addWidget(button) : foot_->insertWidget(stretchInFoot_++, button);
}

void Sheet::fitTo(int widthOfWindow)
{
    const int wanted = widthOfWindow < narrowWindow ? narrowWidth
                       : width_ == Width::Wide      ? wideSheet
                                                    : sheetWidth;
    const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    setFixedWidth(std::max(wanted, inner_->minimumSizeHint().width() + bar + 1));
}

void Sheet::focusFirst()
{
    for (QWidget* next = inner_->nextInFocusChain(); next && next != inner_;
         next = next->nextInFocusChain())
        if (inner_->isAncestorOf(next) && next->isVisibleTo(this) && next->isEnabled()
            && (next->focusPolicy() & Qt::TabFocus))
            return next->setFocus(Qt::TabFocusReason);
}

/// What no field took.
void Sheet::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        return leave();
    QWidget::keyPressEvent(event);
}

} // namespace ui

#include "moc_sheet.cpp"

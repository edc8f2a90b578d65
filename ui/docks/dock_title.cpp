// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/dock_title.h"

#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QPainter>

namespace ui {

DockTitle::DockTitle(QDockWidget& dock)
    : QWidget(&dock), dock_(dock), name_(new QLabel(dock.windowTitle())), remark_(new ElidedLabel),
      row_(new QHBoxLayout(this)), chevron_(new QToolButton)
{
    name_->setFont(semiBold(font()));
    remark_->setForegroundRole(QPalette::PlaceholderText);
    row_->setContentsMargins(space::dockMargin, 0, 4, 0);
    row_->setSpacing(2);
    chevron_->setAutoRaise(true);
    chevron_->setFixedSize(18, 18);
    chevron_->hide();
    connect(chevron_, &QToolButton::clicked, this,
            [this] { emit foldWanted(chevron_->arrowType() == Qt::DownArrow); });
    row_->addWidget(chevron_);
    row_->addWidget(name_);
    row_->addSpacing(6);
    row_->addWidget(remark_, 1);
    auto* floating = new QAction(icon("float"), Text::tr("Detach or attach this panel"), this);
    auto* close = new QAction(icon("close"), Text::tr("Close this panel"), this);
    connect(floating, &QAction::triggered, &dock,
            [&dock] { dock.setFloating(!dock.isFloating()); });
    connect(close, &QAction::triggered, &dock, &QDockWidget::close);
    addButton(floating);
    addButton(close);
    dock.installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, &DockTitle::showButtons);
    showButtons();
}

void DockTitle::setName(const QString& name) { name_->setText(name); }

void DockTitle::setRemark(const QString& remark) { remark_->setWhole(remark); }

void DockTitle::setFoldable(bool foldable) { chevron_->setVisible(foldable); }

void DockTitle::showFolded(bool folded)
{
    chevron_->setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
    chevron_->setToolTip(folded ? Text::tr("Unfold this panel") : Text::tr("Fold this panel"));
    chevron_->setAccessibleName(chevron_->toolTip());
}

void DockTitle::addButton(QAction* action)
{
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setIconSize({16, 16});
    button->setFixedSize(22, 22);
    button->setAccessibleName(action->text());
    auto policy = button->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    button->setSizePolicy(policy);
    row_->addWidget(button);
    buttons_ << button;
}

QSize DockTitle::sizeHint() const { return {120, space::dockTitleHeight}; }

void DockTitle::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().window());
}

bool DockTitle::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() == QEvent::Enter || event->type() == QEvent::Leave)
        showButtons();
    return QWidget::eventFilter(object, event);
}

void DockTitle::showButtons()
{
    const QWidget* focus = QApplication::focusWidget();
    const bool wanted = dock_.underMouse() || (focus && dock_.isAncestorOf(focus));
    for (QToolButton* button : buttons_)
        button->setVisible(wanted);
}

} // namespace ui

#include "moc_dock_title.cpp"

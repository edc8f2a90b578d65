// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/dock_title.h"

#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>

#include <utility>

namespace ui {

namespace {

constexpr int headingSign = 14;

} // namespace

DockTitle::DockTitle(QDockWidget& dock)
    : QWidget(&dock), dock_(dock), chevron_(new FoldButton),
      sign_(new IconSign(QIcon(), headingSign)), name_(new QLabel(dock.windowTitle())),
      remark_(new ElidedLabel), aside_(new QStackedWidget),
      valueSign_(new IconSign("tick", headingSign)), value_(new LookLabel)
{
    name_->setFont(semiBold(font()));
    remark_->setForegroundRole(QPalette::PlaceholderText);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(space::dockMargin, 0, 4, 0);
    row->setSpacing(2);
    row->addWidget(chevron_);
    row->addWidget(sign_);
    row->addSpacing(2);
    row->addWidget(name_);
    row->addSpacing(6);
    row->addWidget(remark_, 1);
    row->addWidget(aside_);
    chevron_->hide();
    sign_->hide();
    showFolded(false);
    connect(chevron_, &FoldButton::foldWanted, this, &DockTitle::foldWanted);
    addValue();
    auto* buttons = new QWidget;
    auto* buttonRow = new QHBoxLayout(buttons);
    buttonRow->setContentsMargins(0, 0, 0, 0);
    buttonRow->setSpacing(2);
    buttonRow->addStretch();
    aside_->addWidget(buttons);
    aside_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    auto* floating = new QAction(icon("float"), Text::tr("Detach or attach this panel"), this);
    auto* close = new QAction(icon("close"), Text::tr("Close this panel"), this);
    connect(floating, &QAction::triggered, &dock,
            [&dock] { dock.setFloating(!dock.isFloating()); });
    connect(close, &QAction::triggered, &dock, &QDockWidget::close);
    addButton(floating, *buttonRow);
    addButton(close, *buttonRow);
    dock.installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, &DockTitle::showButtons);
    showButtons();
}

void DockTitle::addValue()
{
    auto* value = new QWidget;
    auto* row = new QHBoxLayout(value);
    row->setContentsMargins(0, 0, space::dockMargin - 4, 0);
    row->setSpacing(4);
    row->addStretch();
    row->addWidget(valueSign_);
    row->addWidget(value_);
    valueSign_->hide();
    aside_->addWidget(value);
}

void DockTitle::setSign(const QIcon& sign)
{
    sign_->show(sign);
    sign_->setVisible(!sign.isNull());
}

void DockTitle::setName(const QString& name) { name_->setText(name); }

void DockTitle::setRemark(const QString& remark)
{
    remark_->setWhole(remark);
    remark_->setToolTip(remark);
}

void DockTitle::setValue(const SectionValue& value)
{
    if (value == std::exchange(shown_, value))
        return;
    value_->setText(value.text);
    value_->setColour(value.colour);
    if (!value.sign.empty())
        valueSign_->show(value.sign, value.colour);
    valueSign_->setVisible(!value.sign.empty());
    showButtons();
}

void DockTitle::setFoldable(bool foldable)
{
    chevron_->setVisible(foldable);
    constexpr int besideArrow = 4; // which is in the middle of the button
    layout()->setContentsMargins(space::dockMargin - (foldable ? besideArrow : 0), 0, 4, 0);
}

// Of a folded section the buttons appear with the focus: the way back would miss them.
void DockTitle::showFolded(bool folded)
{
    chevron_->show(folded, dock_.windowTitle());
    for (QToolButton* button : aside_->findChildren<QToolButton*>())
        button->setFocusPolicy(folded ? Qt::NoFocus : Qt::TabFocus);
}

void DockTitle::addButton(QAction* action, QLayout& row)
{
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setIconSize({16, 16});
    button->setFixedSize(22, 22);
    button->setAccessibleName(action->text());
    row.addWidget(button);
}

QSize DockTitle::sizeHint() const { return {120, space::dockTitleHeight}; }

void DockTitle::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().window());
}

// The event goes on to the dock, which is dragged by its heading.
void DockTitle::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !chevron_->isHidden())
        pressed_ = event->globalPosition().toPoint();
    event->ignore();
}

void DockTitle::mouseReleaseEvent(QMouseEvent* event)
{
    event->ignore();
    const auto pressed = std::exchange(pressed_, std::nullopt);
    if (pressed
        && (event->globalPosition().toPoint() - *pressed).manhattanLength()
               < QApplication::startDragDistance())
        chevron_->press();
}

// Of a section that folds, the second click would detach it.
void DockTitle::mouseDoubleClickEvent(QMouseEvent* event)
{
    event->setAccepted(!chevron_->isHidden());
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
    aside_->setCurrentIndex(wanted ? 1 : 0);
    aside_->setVisible(wanted || !shown_.text.isEmpty());
}

} // namespace ui

#include "moc_dock_title.cpp"

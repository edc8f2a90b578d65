// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/showing/show_bar.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/look_label.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>

#include <algorithm>

namespace ui {

namespace {

constexpr int widest = 620, fromBottom = 28, fromSide = 24;

} // namespace

ShowBar::ShowBar(QWidget* parent) : QFrame(parent), number_(new QLabel), what_(new ElidedLabel)
{
    setObjectName(QStringLiteral("show-bar"));
    setAccessibleName(Text::tr("Steps of the page"));
    setAutoFillBackground(true);
    number_->setForegroundRole(QPalette::PlaceholderText);
    wearFont(*what_, 1, QFont::DemiBold);
    auto* next = plainButton(Text::tr("Next step"));
    next->setToolTip(Text::tr("Perform this step at once, or begin the next one (Enter)"));
    auto* stop = plainButton(Text::tr("Stop"));
    stop->setToolTip(Text::tr("End the show; the drawing stays open (Esc)"));
    for (QPushButton* button : {next, stop})
        button->setFocusPolicy(Qt::NoFocus); // the keyboard stays with the drawing
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(space::dockMargin, 6, 6, 6);
    row->setSpacing(space::labelToField);
    row->addWidget(number_);
    row->addWidget(what_, 1);
    row->addWidget(next);
    row->addWidget(stop);
    connect(next, &QPushButton::clicked, this, &ShowBar::nextWanted);
    connect(stop, &QPushButton::clicked, this, &ShowBar::stopWanted);
    if (!parent)
        return;
    parent->installEventFilter(this);
    place();
}

void ShowBar::say(int number, int all, const QString& what)
{
    number_->setText(Text::tr("Step %1 of %2").arg(number).arg(all));
    what_->setWhole(what);
    what_->setToolTip(what);
    QAccessibleEvent told(what_, QAccessible::Alert);
    QAccessible::updateAccessibility(&told);
}

bool ShowBar::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(watched, event);
}

void ShowBar::place()
{
    const QSize room = parentWidget()->size();
    const int width = std::min(widest, room.width() - 2 * fromSide), height = sizeHint().height();
    setGeometry((room.width() - width) / 2, room.height() - height - fromBottom, width, height);
    raise();
}

void ShowBar::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    painter.fillRect(rect(), look.panel);
    painter.setPen(look.selection);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

} // namespace ui

#include "moc_show_bar.cpp"

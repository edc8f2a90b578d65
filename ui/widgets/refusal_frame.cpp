// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/refusal_frame.h"

#include "ui/look/look.h"

#include <QEvent>
#include <QPainter>

namespace ui {

RefusalFrame::RefusalFrame(QWidget& field) : QWidget(&field), field_(field)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
    setGeometry(field.rect());
    field.installEventFilter(this);
}

bool RefusalFrame::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show)
        setGeometry(field_.rect());
    if (event->type() == QEvent::KeyPress && !isHidden()) {
        hide();
        emit typed();
    }
    return QWidget::eventFilter(watched, event);
}

void RefusalFrame::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(errorColour(lookOf(palette())), 2));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), space::radius, space::radius);
}

} // namespace ui

#include "moc_refusal_frame.cpp"

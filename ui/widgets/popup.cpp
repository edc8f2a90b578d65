// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/popup.h"

#include "ui/look/look.h"

#include <QKeyEvent>
#include <QLayout>
#include <QPainter>
#include <QScreen>

#include <algorithm>

namespace ui {
namespace {

constexpr int besideWidget = 2; // logical pixels

QPoint placeBelow(const QWidget& widget, const QSize& size)
{
    const QRect screen = widget.screen()->availableGeometry();
    const QPoint below = widget.mapToGlobal(QPoint(0, widget.height() + besideWidget));
    const int left = std::clamp(below.x(), screen.left(),
                                std::max(screen.left(), screen.right() - size.width()));
    const bool fits = below.y() + size.height() <= screen.bottom();
    const int top =
        fits ? below.y() : widget.mapToGlobal(QPoint(0, -besideWidget)).y() - size.height();
    return {left, std::max(screen.top(), top)};
}

} // namespace

Popup::Popup(const QString& name, QWidget* parent) : QFrame(parent, Qt::Popup)
{
    setAccessibleName(name);
    setContentsMargins(1, 1, 1, 1); // the border
}

void Popup::openBelow(const QWidget& widget)
{
    layout()->activate();
    move(placeBelow(widget, sizeHint()));
    show();
}

void Popup::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    painter.setPen(look.border);
    painter.setBrush(look.panel);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void Popup::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        close();
    else
        QFrame::keyPressEvent(event);
}

} // namespace ui

#include "moc_popup.cpp"

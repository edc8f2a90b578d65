// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/zoom_button.h"

#include "ui/look/look.h"
#include "ui/widgets/tabular.h"

namespace ui {

ZoomButton::ZoomButton(QWidget* parent) : QToolButton(parent)
{
    wearCaption(*this);
    setPopupMode(QToolButton::InstantPopup);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
    setFocusPolicy(Qt::TabFocus);
}

void ZoomButton::setWidest(const QString& text)
{
    setFixedWidth(tabularWidth(fontMetrics(), text) + 21);
}

void ZoomButton::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    if (underMouse() || isDown())
        painter.fillRect(rect(), look.hover);
    painter.fillRect(0, 6, 1, height() - 12, look.border);
    if (hasFocus()) {
        painter.setPen(QPen(look.selection, 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
    painter.setPen(look.text);
    drawTabular(painter, rect().adjusted(11, 0, -8, 0), Qt::AlignRight | Qt::AlignVCenter, text());
}

} // namespace ui

#include "moc_zoom_button.cpp"

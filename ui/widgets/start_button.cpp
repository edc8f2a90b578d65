// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/start_button.h"

#include "ui/look/look.h"
#include "ui/look/look_icon.h"

#include <QPainter>

namespace ui {

StartButton::StartButton(std::string_view iconKey, const QString& verb, const QString& what,
                         QWidget* parent)
    : QAbstractButton(parent), what_(what)
{
    setText(verb);
    setIcon(ui::icon(iconKey));
    setAccessibleDescription(what);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAttribute(Qt::WA_Hover);
    setFocusPolicy(Qt::StrongFocus);
}

void StartButton::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double pen = hasFocus() ? 2 : 1;
    painter.setPen(QPen(hasFocus() ? look.selection : look.border, pen));
    painter.setBrush(isDown() ? look.tint : underMouse() ? look.hover : look.base);
    painter.drawRoundedRect(QRectF(rect()).adjusted(pen / 2, pen / 2, -pen / 2, -pen / 2),
                            space::radius, space::radius);
    const int inset = width() < 130 ? 8 : 14;
    icon().paint(&painter, QRect(inset, height() / 2 - 10, 20, 20));
    const QRect words(2 * inset + 20, height() / 2 - 19, width() - 2 * inset - 24, 19);
    painter.setPen(look.text);
    painter.setFont(semiBold(font()));
    painter.drawText(words, Qt::AlignVCenter, text());
    painter.setPen(look.muted);
    painter.setFont(captionFont(font()));
    painter.drawText(words.translated(0, 19), Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(what_, Qt::ElideRight, words.width()));
}

} // namespace ui

#include "moc_start_button.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/buttons.h"

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
    painter.setPen(QPen(hasFocus() ? look.selection : look.control, pen));
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

namespace {

constexpr int captionHeight = 22;

} // namespace

SampleButton::SampleButton(const QString& title, QWidget* parent) : QAbstractButton(parent)
{
    setText(title);
    setAccessibleName(title);
    setToolTip(title);
    setAttribute(Qt::WA_Hover);
    setFocusPolicy(Qt::StrongFocus);
}

int SampleButton::heightFor(int width) { return width * 2 / 3 + captionHeight; }

QRect SampleButton::pictureBox() const { return rect().adjusted(1, 1, -1, -captionHeight); }

void SampleButton::setPicture(const QImage& picture)
{
    picture_ = picture;
    update();
}

void SampleButton::setMarked(bool marked)
{
    marked_ = marked;
    update();
}

void SampleButton::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    const QRect box = pictureBox();
    painter.fillRect(box, lookOnPaper(false).paper);
    if (!picture_.isNull())
        painter.drawImage(box, picture_);
    const bool strong = marked_ || hasFocus();
    painter.setPen(QPen(strong || underMouse() ? look.selection : look.control, strong ? 2 : 1));
    painter.drawRect(box.adjusted(0, 0, -1, -1));
    painter.setPen(look.text);
    painter.setFont(marked_ ? semiBold(captionFont(font())) : captionFont(font()));
    const QRect caption(0, box.bottom() + 1, width(), captionHeight);
    painter.drawText(caption, Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, width()));
}

} // namespace ui

#include "moc_buttons.cpp"

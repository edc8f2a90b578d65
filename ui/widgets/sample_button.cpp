// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/sample_button.h"

#include "ui/look/look.h"

#include <QPainter>

namespace ui {

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
    painter.setPen(QPen(strong || underMouse() ? look.selection : look.border, strong ? 2 : 1));
    painter.drawRect(box.adjusted(0, 0, -1, -1));
    painter.setPen(look.text);
    painter.setFont(marked_ ? semiBold(captionFont(font())) : captionFont(font()));
    const QRect caption(0, box.bottom() + 1, width(), captionHeight);
    painter.drawText(caption, Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, width()));
}

} // namespace ui

#include "moc_sample_button.cpp"

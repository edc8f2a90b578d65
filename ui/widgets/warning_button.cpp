// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/warning_button.h"

#include "ui/look/look.h"
#include "ui/look/look_icon.h"

#include <QAccessible>
#include <QPainter>

namespace ui {
namespace {

constexpr int pictureSize = 14, beside = 8, between = 5; // pixels

} // namespace

WarningButton::WarningButton(QWidget* parent) : QToolButton(parent)
{
    wearCaption(*this);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
    setFocusPolicy(Qt::TabFocus);
    hide();
}

void WarningButton::warn(const QString& words, const QString& sentence)
{
    if (sentence == this->sentence())
        return;
    setText(words);
    setToolTip(sentence);
    setAccessibleName(words);
    setAccessibleDescription(sentence);
    setVisible(!sentence.isEmpty());
    updateGeometry();
    update();
    if (sentence.isEmpty())
        return;
    QAccessibleEvent event(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

QSize WarningButton::sizeHint() const
{
    return {2 * beside + pictureSize + between + fontMetrics().horizontalAdvance(text()),
            fontMetrics().height() + between};
}

void WarningButton::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    painter.fillRect(rect(), look.warningGround);
    if (hasFocus() || underMouse()) {
        painter.setPen(QPen(hasFocus() ? look.selection : look.border, hasFocus() ? 2 : 1));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
    ui::icon("warning").paint(&painter, beside, (height() - pictureSize) / 2, pictureSize,
                              pictureSize);
    painter.setPen(look.warning);
    painter.drawText(rect().adjusted(beside + pictureSize + between, 0, 0, 0),
                     Qt::AlignLeft | Qt::AlignVCenter, text());
}

} // namespace ui

#include "moc_warning_button.cpp"

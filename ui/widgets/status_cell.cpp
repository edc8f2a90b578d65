// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/status_cell.h"

#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/widgets/spoken_role.h"
#include "ui/widgets/tabular.h"

#include <QAccessible>
#include <QPainter>

namespace ui {

StatusCell::StatusCell(const QString& name, QWidget* parent) : QWidget(parent), name_(name)
{
    wearCaption(*this);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
    setSpokenRole(*this, QAccessible::StaticText);
    setAccessibleName(name);
}

void StatusCell::setText(const QString& text)
{
    if (text == text_)
        return;
    text_ = text;
    setAccessibleDescription(text);
    if (tabularWidth(fontMetrics(), text) + 21 > width())
        setWidest(text);
    update();
}

void StatusCell::setWidest(const QString& text)
{
    setFixedWidth(tabularWidth(fontMetrics(), text) + 21);
}

void StatusCell::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    if (text_.isEmpty())
        return;
    painter.fillRect(0, 6, 1, height() - 12, look.border);
    painter.setPen(look.text);
    drawTabular(painter, rect().adjusted(11, 0, -10, 0), Qt::AlignLeft | Qt::AlignVCenter, text_);
}

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
        painter.setPen(QPen(hasFocus() ? look.selection : look.control, hasFocus() ? 2 : 1));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
    ui::icon("warning").paint(&painter, beside, (height() - pictureSize) / 2, pictureSize,
                              pictureSize);
    painter.setPen(look.warning);
    painter.drawText(rect().adjusted(beside + pictureSize + between, 0, 0, 0),
                     Qt::AlignLeft | Qt::AlignVCenter, text());
}

} // namespace ui

#include "moc_status_cell.cpp"

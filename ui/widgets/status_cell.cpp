// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/status_cell.h"

#include "ui/look/look.h"
#include "ui/widgets/tabular.h"

namespace ui {

StatusCell::StatusCell(const QString& name, QWidget* parent) : QWidget(parent), name_(name)
{
    wearCaption(*this);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
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

} // namespace ui

#include "moc_status_cell.cpp"

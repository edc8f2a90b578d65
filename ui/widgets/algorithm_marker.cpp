// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/algorithm_marker.h"

#include "app/base/text.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QPainter>

namespace ui {

namespace {

constexpr int markerSize = 12, markerRoom = 20;

} // namespace

void paintVariantName(QPainter& painter, const QRect& cell, const QStyleOptionViewItem& option,
                      const app::Variant& variant)
{
    const Look& look = lookOf(option.palette);
    app::paintMarker(painter, QRectF(cell.left(), cell.center().y() - 5.5, markerSize, markerSize),
                     variant, groundOf(option.palette));
    QRect text = cell.adjusted(markerRoom, 0, 0, 0);
    const QFont bold = semiBold(option.font);
    const QString name = variant.misprint ? QString() : app::latin(variant.algorithm->abbreviation);
    painter.setFont(bold);
    painter.setPen(look.text);
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, name);
    if (variant.form != clipping::Form::Published)
        return;
    if (!variant.misprint)
        text.setLeft(text.left() + QFontMetrics(bold).horizontalAdvance(name) + 8);
    QString aside = variant.misprint ? variant.misprint->name : Text::tr("as published");
    if (!variant.misprint && option.fontMetrics.horizontalAdvance(aside) > text.width())
        aside = Text::tr("pub.");
    painter.setFont(option.font);
    painter.setPen(look.muted);
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                     option.fontMetrics.elidedText(aside, Qt::ElideRight, text.width()));
}

} // namespace ui

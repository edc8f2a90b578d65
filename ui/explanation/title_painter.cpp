// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/explanation/title_painter.h"

#include "ui/docks/algorithm_list.h"
#include "ui/look/look.h"
#include "ui/widgets/variant_name.h"

#include <QPainter>

namespace ui {

namespace {

constexpr int nameAt = 76, height = 34;

} // namespace

QSize TitlePainter::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const
{
    return {160, height};
}

void TitlePainter::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const
{
    const auto& algorithm = clipping::algorithms()[std::size_t(index.row())];
    const QRect row = option.rect.adjusted(space::dockMargin, 0, -space::labelToField, 0);
    drawRowGround(*painter, option);
    paintVariantName(*painter, row, option, {&algorithm, clipping::Form::Corrected});
    const QRect name = row.adjusted(nameAt, 0, 0, 0);
    painter->setFont(captionFont(option.font));
    painter->setPen(lookOf(option.palette).muted);
    painter->drawText(
        name, Qt::AlignLeft | Qt::AlignVCenter,
        painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, name.width()));
}

} // namespace ui

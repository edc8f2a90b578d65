// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/compare_cells.h"

#include "app/charts/sparkline.h"
#include "ui/look/look.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/tabular.h"

#include <QPainter>
#include <QSortFilterProxyModel>

namespace ui {

CompareCells::CompareCells(const CompareModel& model, DenseTable& table)
    : QStyledItemDelegate(&table), model_(model), table_(table)
{
}

void CompareCells::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const
{
    const auto* sorted = qobject_cast<const QSortFilterProxyModel*>(index.model());
    const app::RaceRow& row = model_.row(sorted->mapToSource(index).row());
    table_.paintGround(*painter, option, index);
    if (index.column() == CompareModel::Name)
        paintName(*painter, option, row);
    else if (index.column() == CompareModel::Sparkline)
        paintSparkline(*painter, option, row);
    else
        paintNumber(*painter, option, index, row);
}

void CompareCells::paintName(QPainter& painter, const QStyleOptionViewItem& option,
                             const app::RaceRow& row) const
{
    paintVariantName(painter, option.rect.adjusted(space::dockMargin, 0, 0, 0), option,
                     row.variant);
}

void CompareCells::paintSparkline(QPainter& painter, const QStyleOptionViewItem& option,
                                  const app::RaceRow& row) const
{
    if (!model_.timed())
        return;
    const QRect r = option.rect.adjusted(DenseTable::gap, 3, -DenseTable::gap, -3);
    app::paint(painter, r, {row.milliseconds, app::Race::length},
               app::algorithmColour(*row.variant.algorithm, groundOf(option.palette)));
}

void CompareCells::paintNumber(QPainter& painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index, const app::RaceRow& row) const
{
    const Look& look = lookOf(option.palette);
    const bool differs = index.column() == CompareModel::Differ && row.differences.all() > 0;
    const bool limited = index.column() == CompareModel::Here
                         && !app::limitText(row.variant, model_.needs()).isEmpty();
    const bool quiet = limited || index.column() == CompareModel::Spread
                       || (index.column() == CompareModel::Differ && !differs);
    painter.setFont(differs ? semiBold(option.font) : option.font);
    painter.setPen(differs                                ? look.differs
                   : quiet                                ? look.muted
                   : index.column() == CompareModel::Here ? look.good
                                                          : look.text);
    drawTabular(painter, option.rect.adjusted(0, 0, -DenseTable::gap, 0),
                Qt::AlignRight | Qt::AlignVCenter, index.data().toString());
}

} // namespace ui

#include "moc_compare_cells.cpp"

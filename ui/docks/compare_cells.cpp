// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/compare_cells.h"

#include "app/charts/sparkline.h"
#include "app/latin.h"
#include "ui/look.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/tabular.h"

#include <QCoreApplication>
#include <QPainter>
#include <QSortFilterProxyModel>

namespace ui {

namespace {

constexpr int markerSize = 12, markerRoom = 20;

} // namespace

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
    const Look& look = lookOf(option.palette);
    const auto& [algorithm, form] = row.contestant;
    const QRect r = option.rect.adjusted(space::dockMargin, 0, 0, 0);
    app::paintMarker(painter, QRectF(r.left(), r.center().y() - 5.5, markerSize, markerSize),
                     *algorithm, form, groundOf(option.palette));
    const QFont bold = semiBold(option.font);
    const auto name = app::latin(algorithm->abbreviation);
    QRect text = r.adjusted(markerRoom, 0, 0, 0);
    painter.setFont(bold);
    painter.setPen(look.text);
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, name);
    if (form != clipping::Form::Published)
        return;
    text.setLeft(text.left() + QFontMetrics(bold).horizontalAdvance(name) + 8);
    QString published = QCoreApplication::translate("Compare", "as published");
    if (option.fontMetrics.horizontalAdvance(published) > text.width())
        published = QCoreApplication::translate("Compare", "pub.");
    painter.setFont(option.font);
    painter.setPen(look.muted);
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, published);
}

void CompareCells::paintSparkline(QPainter& painter, const QStyleOptionViewItem& option,
                                  const app::RaceRow& row) const
{
    if (!model_.timed())
        return;
    const QRect r = option.rect.adjusted(DenseTable::gap, 3, -DenseTable::gap, -3);
    app::paint(painter, r, {row.milliseconds, app::Race::length},
               app::algorithmColour(*row.contestant.algorithm, groundOf(option.palette)));
}

void CompareCells::paintNumber(QPainter& painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index, const app::RaceRow& row) const
{
    const Look& look = lookOf(option.palette);
    const bool differs = index.column() == CompareModel::Differ && row.differences.all() > 0;
    const bool quiet = index.column() == CompareModel::Spread
                       || (index.column() == CompareModel::Differ && !differs);
    painter.setFont(differs ? semiBold(option.font) : option.font);
    painter.setPen(differs ? look.differs : quiet ? look.muted : look.text);
    drawTabular(painter, option.rect.adjusted(0, 0, -DenseTable::gap, 0),
                Qt::AlignRight | Qt::AlignVCenter, index.data().toString());
}

} // namespace ui

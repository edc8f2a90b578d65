// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/table_model.h"

#include "app/base/latin.h"
#include "app/base/numbers.h"
#include "app/experiment/heading.h"
#include "app/experiment/one_by_one.h"
#include "app/experiment/record.h"

#include <QStringList>

namespace ui {

namespace {

/// The number in the locale's format, with as many decimals as the field has.
QString numberInWords(const QString& field)
{
    const qsizetype point = field.indexOf(u'.');
    const bool scientific = field.contains(u'e', Qt::CaseInsensitive);
    const qsizetype decimals = point < 0 || scientific ? 0 : field.size() - point - 1;
    return scientific ? field : app::numberText(field.toDouble(), int(decimals));
}

} // namespace

void TableModel::show(app::Table table)
{
    beginResetModel();
    table_ = std::move(table);
    numeric_ = app::numericColumns(table_);
    if (const auto checksum = table_.names.indexOf(QStringLiteral("checksum")); checksum >= 0)
        numeric_[std::size_t(checksum)] = false; // a checksum may consist of digits alone
    endResetModel();
}

int TableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(table_.rows.size());
}

int TableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(table_.names.size());
}

const QString& TableModel::field(const QModelIndex& index) const
{
    return table_.rows[std::size_t(index.row())][index.column()];
}

/// Key and form of the algorithm in a cell.
QVariant TableModel::variant(const QModelIndex& index) const
{
    const auto* algorithm = app::timedAlgorithm(field(index));
    if (table_.names[index.column()] != u"algorithm" || !algorithm)
        return {};
    const auto form = table_.names.indexOf(QStringLiteral("form"));
    const auto published = app::wordOf(clipping::Form::Published);
    return QStringList{app::latin(algorithm->key),
                       form >= 0 ? table_.rows[std::size_t(index.row())][form]
                       : table_.key.contains(published) ? published // all rows have the same form
                                                        : QString()};
}

bool TableModel::isFault(const QModelIndex& index) const
{
    static const QStringList counted{"lost", "shown", "outside", "wrong"};
    return counted.contains(table_.names[index.column()]) && field(index) != u"0";
}

QString TableModel::shown(const QModelIndex& index) const
{
    const QString& text = field(index);
    if (table_.names[index.column()] == u"algorithm")
        if (const auto* algorithm = text == u"Prop." ? nullptr : app::timedAlgorithm(text))
            return app::latin(algorithm->abbreviation);
    return numeric_[std::size_t(index.column())] && !text.isEmpty() ? numberInWords(text) : text;
}

QVariant TableModel::data(const QModelIndex& index, int role) const
{
    const bool numeric = numeric_[std::size_t(index.column())];
    switch (role) {
    case Qt::DisplayRole:
        return shown(index);
    case Qt::TextAlignmentRole:
        return int(Qt::AlignVCenter | (numeric ? Qt::AlignRight : Qt::AlignLeft));
    case Qt::ToolTipRole:
        if (const auto* algorithm =
                variant(index).isValid() ? app::timedAlgorithm(field(index)) : nullptr)
            return app::latin(algorithm->name);
        return {};
    case SortRole:
        return numeric && !field(index).isEmpty() ? QVariant(field(index).toDouble())
                                                  : QVariant(shown(index));
    case VariantRole:
        return variant(index);
    case FaultRole:
        return isFault(index);
    default:
        return {};
    }
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section >= table_.names.size())
        return {};
    const auto heading = app::headingOf(table_.names[section]);
    switch (role) {
    case Qt::DisplayRole:
        return heading.text;
    case Qt::ToolTipRole:
        return heading.meaning;
    case Qt::TextAlignmentRole:
        return int(Qt::AlignBottom
                   | (numeric_[std::size_t(section)] ? Qt::AlignRight : Qt::AlignLeft));
    default:
        return {};
    }
}

} // namespace ui

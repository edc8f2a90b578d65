// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/table_model.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
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

int TableModel::rows() const { return int(table_.rows.size()); }

int TableModel::columns() const { return int(table_.names.size()); }

const QString& TableModel::field(int row, int column) const
{
    return table_.rows[std::size_t(row)][column];
}

/// Key and form of the algorithm in a cell.
QVariant TableModel::variant(int row, int column) const
{
    const auto* algorithm = app::timedAlgorithm(field(row, column));
    if (table_.names[column] != u"algorithm" || !algorithm)
        return {};
    const auto form = table_.names.indexOf(QStringLiteral("form"));
    const auto published = app::wordOf(clipping::Form::Published);
    return QStringList{app::latin(algorithm->key),
                       form >= 0                        ? table_.rows[std::size_t(row)][form]
                       : table_.key.contains(published) ? published // all rows have the same form
                                                        : QString()};
}

bool TableModel::isFault(int row, int column) const
{
    static const QStringList counted{"lost", "shown", "outside", "wrong"};
    return counted.contains(table_.names[column]) && field(row, column) != u"0";
}

QString TableModel::shown(int row, int column) const
{
    const QString& text = field(row, column);
    if (table_.names[column] == u"algorithm")
        if (const auto* algorithm = text == u"Prop." ? nullptr : app::timedAlgorithm(text))
            return app::latin(algorithm->abbreviation);
    return numeric_[std::size_t(column)] && !text.isEmpty() ? numberInWords(text) : text;
}

QVariant TableModel::cell(int row, int column, int role) const
{
    const bool numeric = numeric_[std::size_t(column)];
    switch (role) {
    case Qt::DisplayRole:
        return shown(row, column);
    case Qt::TextAlignmentRole:
        return sideOf(numeric);
    case Qt::ToolTipRole:
        if (const auto* algorithm =
                variant(row, column).isValid() ? app::timedAlgorithm(field(row, column)) : nullptr)
            return app::latin(algorithm->name);
        return {};
    case SortRole:
        return numeric && !field(row, column).isEmpty() ? QVariant(field(row, column).toDouble())
                                                        : QVariant(shown(row, column));
    case VariantRole:
        return variant(row, column);
    case FaultRole:
        return isFault(row, column);
    default:
        return {};
    }
}

QVariant TableModel::heading(int column, int role) const
{
    const auto heading = app::headingOf(table_.names[column]);
    switch (role) {
    case Qt::DisplayRole:
        return heading.text;
    case Qt::ToolTipRole:
        return heading.meaning;
    case Qt::TextAlignmentRole:
        return int(Qt::AlignBottom
                   | (numeric_[std::size_t(column)] ? Qt::AlignRight : Qt::AlignLeft));
    default:
        return {};
    }
}

} // namespace ui

#include "moc_table_model.cpp"

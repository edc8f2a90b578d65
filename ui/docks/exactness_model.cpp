// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/exactness_model.h"

#include "app/exactness/exactness_columns.h"

#include <algorithm>

namespace ui {

namespace {

const app::ExactnessColumn& columnOf(int column)
{
    return app::exactnessColumns()[std::size_t(column)];
}

int sideOf(int column)
{
    return int((columnOf(column).number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

} // namespace

ExactnessModel::ExactnessModel(const app::Session& session, QObject* parent)
    : QAbstractTableModel(parent), session_(session), column_(app::errorColumn)
{
    follow();
}

int ExactnessModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(rows_.size());
}

int ExactnessModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(app::exactnessColumns().size());
}

QVariant ExactnessModel::data(const QModelIndex& index, int role) const
{
    const app::LineExactness* exactness = exactnessOf(index.row());
    if (!exactness)
        return {};
    if (role == Qt::DisplayRole)
        return columnOf(index.column()).text(*exactness);
    if (role == Qt::TextAlignmentRole)
        return sideOf(index.column());
    return {};
}

QVariant ExactnessModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return sideOf(section);
    if (role == Qt::DisplayRole)
        return columnOf(section).heading;
    if (role == Qt::ToolTipRole)
        return columnOf(section).meaning;
    return {};
}

void ExactnessModel::sort(int column, Qt::SortOrder order)
{
    beginResetModel();
    column_ = column;
    order_ = order;
    rows_ = app::sortedBy(session_.exactness.found().list, columnOf(column), order);
    endResetModel();
}

const app::LineExactness* ExactnessModel::exactnessOf(int row) const
{
    const auto& list = session_.exactness.found().list;
    if (row < 0 || row >= int(rows_.size()) || rows_[std::size_t(row)] >= list.size())
        return nullptr;
    const app::LineExactness& exactness = list[rows_[std::size_t(row)]];
    return exactness.source < session_.scene.lines().size() ? &exactness : nullptr;
}

int ExactnessModel::rowOf(std::size_t line) const
{
    const auto& list = session_.exactness.found().list;
    const auto found = std::ranges::lower_bound(list, line, {}, &app::LineExactness::source);
    if (found == list.end() || found->source != line)
        return -1;
    const auto row = std::ranges::find(rows_, std::uint32_t(found - list.begin()));
    return row == rows_.end() ? -1 : int(row - rows_.begin());
}

void ExactnessModel::follow() { sort(column_, order_); }

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/exactness_model.h"

#include "app/exactness/exactness_columns.h"

#include <algorithm>

namespace ui {

namespace {

const app::ExactnessColumn& exactnessColumn(int column)
{
    return app::exactnessColumns()[std::size_t(column)];
}

} // namespace

ExactnessModel::ExactnessModel(const app::Session& session, QObject* parent)
    : CheckedModel(parent), session_(session), column_(app::errorColumn)
{
    follow();
}

int ExactnessModel::rows() const { return int(rows_.size()); }

int ExactnessModel::columns() const { return int(app::exactnessColumns().size()); }

QVariant ExactnessModel::cell(int row, int column, int role) const
{
    const app::LineExactness* exactness = exactnessOf(row);
    if (!exactness)
        return {};
    if (role == Qt::DisplayRole)
        return exactnessColumn(column).text(*exactness);
    if (role == Qt::TextAlignmentRole)
        return sideOf(exactnessColumn(column).number);
    return {};
}

QVariant ExactnessModel::heading(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return sideOf(exactnessColumn(column).number);
    if (role == Qt::DisplayRole)
        return exactnessColumn(column).heading;
    if (role == Qt::ToolTipRole)
        return exactnessColumn(column).meaning;
    return {};
}

void ExactnessModel::sortBy(int column, Qt::SortOrder order)
{
    beginResetModel();
    column_ = column;
    order_ = order;
    rows_ = app::sortedBy(session_.exactness.found().list, exactnessColumn(column), order);
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

void ExactnessModel::follow() { sortBy(column_, order_); }

} // namespace ui

#include "moc_exactness_model.cpp"

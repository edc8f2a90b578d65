// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/difference_model.h"

#include "app/session/difference_row.h"

#include <algorithm>

namespace ui {

namespace {

const app::DifferenceColumn& differenceColumn(int column)
{
    return app::differenceColumns()[std::size_t(column)];
}

} // namespace

DifferenceModel::DifferenceModel(const app::Session& session, QObject* parent)
    : CheckedModel(parent), session_(session)
{
    connect(&session, &app::Session::displayChanged, this,
            [this] { tellChanged(); }); // the unit may have changed
    follow();
}

int DifferenceModel::rows() const { return int(rows_.size()); }

int DifferenceModel::columns() const { return int(app::differenceColumns().size()); }

QVariant DifferenceModel::cell(int row, int column, int role) const
{
    const auto& list = session_.differences.found().list;
    const std::uint32_t at = rows_[std::size_t(row)];
    if (at >= list.size())
        return {}; // the list has changed; follow() will be called
    if (role == Qt::DisplayRole)
        return differenceColumn(column).text(session_, list[at]);
    if (role == Qt::TextAlignmentRole)
        return sideOf(differenceColumn(column).number);
    if (role == Qt::ToolTipRole)
        return app::piecesInFull(session_, list[at]);
    return {};
}

QVariant DifferenceModel::heading(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return sideOf(differenceColumn(column).number);
    const auto comparison =
        session_.differences.asked().value_or(app::Comparison{app::exactVariant()});
    if (role == Qt::DisplayRole)
        return differenceColumn(column).heading(comparison);
    if (role == Qt::ToolTipRole)
        return differenceColumn(column).meaning(comparison);
    return {};
}

void DifferenceModel::sortBy(int column, Qt::SortOrder order)
{
    beginResetModel();
    column_ = column;
    order_ = order;
    rows_ = app::sortedBy(session_, differenceColumn(column), order);
    endResetModel();
}

std::optional<std::size_t> DifferenceModel::lineOf(int row) const
{
    const auto& list = session_.differences.found().list;
    if (row < 0 || row >= int(rows_.size()))
        return std::nullopt;
    const std::uint32_t at = rows_[std::size_t(row)];
    if (at >= list.size() || list[at].source >= session_.scene.lines().size())
        return std::nullopt;
    return list[at].source;
}

int DifferenceModel::rowOf(std::size_t line) const
{
    const auto& list = session_.differences.found().list;
    const auto found = std::ranges::lower_bound(list, line, {}, &app::Difference::source);
    if (found == list.end() || found->source != line)
        return -1;
    const auto row = std::ranges::find(rows_, std::uint32_t(found - list.begin()));
    return row == rows_.end() ? -1 : int(row - rows_.begin());
}

void DifferenceModel::follow()
{
    sortBy(column_, order_);
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

} // namespace ui

#include "moc_difference_model.cpp"

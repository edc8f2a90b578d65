// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/truth_model.h"

#include "app/exactness/truth_row.h"

#include <algorithm>

namespace ui {

namespace {

const app::TruthColumn& columnOf(int column) { return app::truthColumns()[std::size_t(column)]; }

int sideOf(int column)
{
    return int((columnOf(column).number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

} // namespace

TruthModel::TruthModel(const app::Session& session, QObject* parent)
    : QAbstractTableModel(parent), session_(session), column_(app::errorColumn)
{
    follow();
}

int TruthModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(rows_.size());
}

int TruthModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(app::truthColumns().size());
}

QVariant TruthModel::data(const QModelIndex& index, int role) const
{
    const app::LineTruth* truth = truthOf(index.row());
    if (!truth)
        return {};
    if (role == Qt::DisplayRole)
        return columnOf(index.column()).text(*truth);
    if (role == Qt::TextAlignmentRole)
        return sideOf(index.column());
    return {};
}

QVariant TruthModel::headerData(int section, Qt::Orientation orientation, int role) const
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

void TruthModel::sort(int column, Qt::SortOrder order)
{
    beginResetModel();
    column_ = column;
    order_ = order;
    rows_ = app::sortedBy(session_.truth.found().list, columnOf(column), order);
    endResetModel();
}

const app::LineTruth* TruthModel::truthOf(int row) const
{
    const auto& list = session_.truth.found().list;
    if (row < 0 || row >= int(rows_.size()) || rows_[std::size_t(row)] >= list.size())
        return nullptr;
    const app::LineTruth& truth = list[rows_[std::size_t(row)]];
    return truth.source < session_.scene.lines().size() ? &truth : nullptr;
}

int TruthModel::rowOf(std::size_t line) const
{
    const auto& list = session_.truth.found().list;
    const auto found = std::ranges::lower_bound(list, line, {}, &app::LineTruth::source);
    if (found == list.end() || found->source != line)
        return -1;
    const auto row = std::ranges::find(rows_, std::uint32_t(found - list.begin()));
    return row == rows_.end() ? -1 : int(row - rows_.begin());
}

void TruthModel::follow() { sort(column_, order_); }

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

namespace ui {

/// The base of every model of a list or a table. A view also asks about cells that do not exist:
/// with an invalid index if it has no current row (Ctrl+C), or with one of a row that is gone. A
/// model is asked only about its cells.
class CheckedModel : public QAbstractTableModel {
public:
    using QAbstractTableModel::QAbstractTableModel;

    using QAbstractTableModel::index;
    QModelIndex index(int row) const { return index(row, 0); }

    int rowCount(const QModelIndex& parent = {}) const final
    {
        return parent.isValid() ? 0 : rows();
    }
    int columnCount(const QModelIndex& parent = {}) const final
    {
        return parent.isValid() ? 0 : columns();
    }
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const final
    {
        return isCell(index) ? cell(index.row(), index.column(), role) : QVariant();
    }
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) final
    {
        return isCell(index) && change(index.row(), value, role);
    }
    Qt::ItemFlags flags(const QModelIndex& index) const final
    {
        return isCell(index) ? QAbstractTableModel::flags(index) | moreFlags() : Qt::NoItemFlags;
    }
    QVariant headerData(int section, Qt::Orientation orientation,
                        int role = Qt::DisplayRole) const final
    {
        return orientation == Qt::Horizontal && section >= 0 && section < columns()
                   ? heading(section, role)
                   : QVariant();
    }
    void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) final
    {
        if (column >= 0 && column < columns())
            sortBy(column, order);
    }

protected:
    virtual int rows() const = 0;
    virtual int columns() const { return 1; }
    virtual QVariant cell(int row, int column, int role) const = 0;
    virtual QVariant heading(int /*column*/, int /*role*/) const { return {}; }
    virtual bool change(int /*row*/, const QVariant& /*value*/, int /*role*/) { return false; }
    virtual Qt::ItemFlags moreFlags() const { return Qt::NoItemFlags; } ///< of every cell
    virtual void sortBy(int /*column*/, Qt::SortOrder) {}

    /// Tells the views that all cells have changed; the rows are the same.
    void tellChanged(const QList<int>& roles = {})
    {
        if (rows() > 0)
            emit dataChanged(index(0, 0), index(rows() - 1, columns() - 1), roles);
    }

    /// Of a column: numbers are at the right.
    static QVariant sideOf(bool number)
    {
        return int((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    }

    bool isCell(const QModelIndex& index) const
    {
        return index.model() == this && hasIndex(index.row(), index.column());
    }
};

} // namespace ui

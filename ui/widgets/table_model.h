// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tables/table.h"

#include <QAbstractTableModel>

namespace ui {

/// A table of an experiment for display: headings instead of column names, numbers in the locale's
/// format and right-aligned, algorithms by their abbreviations.
class TableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Role {
        SortRole = Qt::UserRole, ///< a number where the column has numbers
        VariantRole,             ///< an algorithm cell's key and form
        FaultRole                ///< true if the cell counts errors and is not 0
    };

    using QAbstractTableModel::QAbstractTableModel;

    void show(app::Table table);
    const app::Table& table() const { return table_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    const QString& field(const QModelIndex& index) const;
    QVariant variant(const QModelIndex& index) const;
    bool isFault(const QModelIndex& index) const;
    QString shown(const QModelIndex& index) const;

    app::Table table_;
    std::vector<bool> numeric_;
};

} // namespace ui

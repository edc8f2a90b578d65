// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tables/table.h"
#include "ui/widgets/checked_model.h"

namespace ui {

/// A table of an experiment for display: headings instead of column names, numbers in the locale's
/// format and right-aligned, algorithms by their abbreviations.
class TableModel : public CheckedModel {
    Q_OBJECT

public:
    enum Role {
        SortRole = Qt::UserRole, ///< a number where the column has numbers
        VariantRole,             ///< an algorithm cell's key and form
        FaultRole                ///< true if the cell counts errors and is not 0
    };

    using CheckedModel::CheckedModel;

    void show(app::Table table);
    const app::Table& table() const { return table_; }

protected:
    int rows() const override;
    int columns() const override;
    QVariant cell(int row, int column, int role) const override;
    QVariant heading(int column, int role) const override;

private:
    const QString& field(int row, int column) const;
    QVariant variant(int row, int column) const;
    bool isFault(int row, int column) const;
    QString shown(int row, int column) const;

    app::Table table_;
    std::vector<bool> numeric_;
};

} // namespace ui

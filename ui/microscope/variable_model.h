// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"

#include <QAbstractTableModel>

namespace ui {

/// The variables after a step: name, value, previous value, and whether the step changed it.
class VariableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Value, Before, Change, ColumnCount };
    /// ShortRole: a shortened text for narrow columns.
    enum Role { ChangedRole = Qt::UserRole, ShortRole };

    using QAbstractTableModel::QAbstractTableModel;

    void show(std::vector<app::Variable> variables);
    /// The row of the first variable that the step changed; -1: none.
    int firstChanged() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(const app::Variable& variable, int column) const;

    std::vector<app::Variable> variables_;
};

} // namespace ui

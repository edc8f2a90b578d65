// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"
#include "ui/widgets/checked_model.h"

namespace ui {

/// The variables after a step: name, value, previous value, and whether the step changed it.
class VariableModel : public CheckedModel {
    Q_OBJECT

public:
    enum Column { Name, Value, Before, Change, ColumnCount };
    /// ShortRole: a shortened text for narrow columns.
    enum Role { ChangedRole = Qt::UserRole, ShortRole };

    using CheckedModel::CheckedModel;

    void show(std::vector<app::Variable> variables);
    /// The row of the first variable that the step changed; -1: none.
    int firstChanged() const;

protected:
    int rows() const override;
    int columns() const override;
    QVariant cell(int row, int column, int role) const override;
    QVariant heading(int column, int role) const override;

private:
    QString text(const app::Variable& variable, int column) const;

    std::vector<app::Variable> variables_;
};

} // namespace ui

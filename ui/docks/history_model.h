// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/history.h"
#include "ui/widgets/checked_model.h"

namespace ui {

/// The steps of the history, the oldest first. Row 0 is the state before them; row n is the state
/// after n steps.
class HistoryModel : public CheckedModel {
    Q_OBJECT

public:
    enum Role { UndoneRole = Qt::UserRole, SavedRole };

    explicit HistoryModel(const app::History& history, QObject* parent = nullptr);

    QModelIndex now() const { return index(history_.index()); }

protected:
    int rows() const override { return rows_; }
    QVariant cell(int row, int column, int role) const override;

private:
    void follow();

    const app::History& history_;
    int rows_; ///< as last reported to views
};

} // namespace ui

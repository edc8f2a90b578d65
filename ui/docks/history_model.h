// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/history.h"

#include <QAbstractListModel>

namespace ui {

/// The steps of the history, the oldest first. Row 0 is the state before them; row n is the state
/// after n steps.
class HistoryModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role { UndoneRole = Qt::UserRole, SavedRole };

    explicit HistoryModel(const app::History& history, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QModelIndex now() const { return index(history_.index()); }

private:
    void follow();

    const app::History& history_;
    int rows_; ///< as last reported to views
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QAbstractTableModel>

namespace ui {

/// The lines that were judged, sorted; the worst come first. Only rows that are shown are put into
/// words; when, its panel says.
class TruthModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit TruthModel(const app::Session& session, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    void sort(int column, Qt::SortOrder order) override;
    void follow(); ///< shows what is found now

    /// What was found of a row's line; null if it is gone.
    const app::LineTruth* truthOf(int row) const;
    int rowOf(std::size_t line) const; ///< -1: it is not in the list

private:
    const app::Session& session_;
    std::vector<std::uint32_t> rows_; ///< indices into the list that was found
    int column_;
    Qt::SortOrder order_ = Qt::DescendingOrder;
};

} // namespace ui

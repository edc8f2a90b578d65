// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QAbstractTableModel>

namespace ui {

/// The lines that differ, sorted. Only the rows that are shown are put into words, so that half a
/// million of them cost no more than a sort; when, its panel says.
class DifferenceModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit DifferenceModel(const app::Session& session, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    void sort(int column, Qt::SortOrder order) override;
    void follow(); ///< shows what is found now

    /// The line of a row, one of the scene's; nothing if it is gone.
    std::optional<std::size_t> lineOf(int row) const;
    /// The row of a line; -1 if it does not differ.
    int rowOf(std::size_t line) const;

private:
    const app::Session& session_;
    std::vector<std::uint32_t> rows_; ///< indices into the list that was found
    int column_ = 0;
    Qt::SortOrder order_ = Qt::AscendingOrder;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/race/race.h"

#include <QAbstractTableModel>

namespace ui {

/// The rows of a race as a table: the columns' headings, texts and sort keys.
class CompareModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Sparkline, Median, Spread, Operations, Visible, Differ };
    enum Role { OrderRole = Qt::UserRole };

    using QAbstractTableModel::QAbstractTableModel;
    /// Resets the model if the variants are others than before.
    void show(std::span<const app::RaceRow> rows, std::size_t lines);

    const app::RaceRow& row(int number) const { return rows_[std::size_t(number)]; }
    std::size_t lines() const { return lines_; }
    bool timed() const; ///< the drawing has enough lines for meaningful times
    bool sortsBy(int column) const { return timed() || column < Sparkline || column > Spread; }
    int rowOf(const app::Variant& variant) const; ///< -1: the variant has no row

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<app::RaceRow> rows_;
    std::vector<app::Summary> summaries_; ///< one per row
    std::size_t lines_ = 0;
};

} // namespace ui

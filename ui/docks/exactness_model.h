// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QAbstractTableModel>

namespace ui {

/// The judged lines, sorted, by default worst first. Texts are made for visible rows only. The
/// panel calls follow() when new results should be shown.
class ExactnessModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit ExactnessModel(const app::Session& session, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    void sort(int column, Qt::SortOrder order) override;
    void follow(); ///< shows the current results

    /// The result for a row's line; null if the line no longer exists.
    const app::LineExactness* exactnessOf(int row) const;
    int rowOf(std::size_t line) const; ///< -1: it is not in the list

private:
    const app::Session& session_;
    std::vector<std::uint32_t> rows_; ///< indices into the list of results
    int column_;
    Qt::SortOrder order_ = Qt::DescendingOrder;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "ui/widgets/checked_model.h"

namespace ui {

/// The judged lines, sorted, by default worst first. Texts are made for visible rows only. The
/// panel calls follow() when new results should be shown.
class ExactnessModel final : public CheckedModel {
    Q_OBJECT

public:
    explicit ExactnessModel(const app::Session& session, QObject* parent = nullptr);

    void follow(); ///< shows the current results

    /// The result for a row's line; null if the line no longer exists.
    const app::LineExactness* exactnessOf(int row) const;
    int rowOf(std::size_t line) const; ///< -1: it is not in the list

protected:
    int rows() const override;
    int columns() const override;
    QVariant cell(int row, int column, int role) const override;
    QVariant heading(int column, int role) const override;
    void sortBy(int column, Qt::SortOrder order) override;

private:
    const app::Session& session_;
    std::vector<std::uint32_t> rows_; ///< indices into the list of results
    int column_;
    Qt::SortOrder order_ = Qt::DescendingOrder;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "ui/widgets/checked_model.h"

namespace ui {

/// The lines that differ, sorted. Texts are made for visible rows only, so half a million lines
/// cost no more than a sort. The panel calls follow() when new results should be shown.
class DifferenceModel final : public CheckedModel {
    Q_OBJECT

public:
    explicit DifferenceModel(const app::Session& session, QObject* parent = nullptr);

    void follow(); ///< shows the current results

    /// The scene's line in a row; nothing if it no longer exists.
    std::optional<std::size_t> lineOf(int row) const;
    /// The row of a line; -1 if it does not differ.
    int rowOf(std::size_t line) const;

protected:
    int rows() const override;
    int columns() const override;
    QVariant cell(int row, int column, int role) const override;
    QVariant heading(int column, int role) const override;
    void sortBy(int column, Qt::SortOrder order) override;

private:
    const app::Session& session_;
    std::vector<std::uint32_t> rows_; ///< indices into the list of results
    int column_ = 0;
    Qt::SortOrder order_ = Qt::AscendingOrder;
};

} // namespace ui

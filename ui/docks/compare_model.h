// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/race/race.h"
#include "app/scene/window_needs.h"
#include "ui/widgets/checked_model.h"

namespace ui {

/// The rows of a race as a table: the columns' headings, texts and sort keys. Rows without times
/// were not measured: they have no numbers.
class CompareModel : public CheckedModel {
    Q_OBJECT

public:
    enum Column { Name, Sparkline, Median, Spread, Operations, Visible, Differ, Here };
    enum Role { OrderRole = Qt::UserRole };

    using CheckedModel::CheckedModel;
    /// Resets the model if the variants are others than before. `needs`: what the clip windows of
    /// the drawing demand of an algorithm.
    void show(std::span<const app::RaceRow> rows, std::size_t lines,
              app::WindowNeeds needs = app::WindowNeeds::Rectangle);

    const app::RaceRow& row(int number) const { return rows_[std::size_t(number)]; }
    std::size_t lines() const { return lines_; }
    bool timed() const; ///< the drawing has enough lines for meaningful times
    bool sortsBy(int column) const { return timed() || column < Sparkline || column > Spread; }
    app::WindowNeeds needs() const { return needs_; }
    /// Whether not every algorithm can clip at all of the windows.
    bool limits() const { return needs_ > app::WindowNeeds::RotatedRectangle; }
    int rowOf(const app::Variant& variant) const; ///< -1: the variant has no row

protected:
    int rows() const override;
    int columns() const override;
    QVariant cell(int row, int column, int role) const override;
    QVariant heading(int column, int role) const override;

private:
    std::vector<app::RaceRow> rows_;
    std::vector<app::Summary> summaries_; ///< one per row
    std::size_t lines_ = 0;
    app::WindowNeeds needs_ = app::WindowNeeds::Rectangle;
};

} // namespace ui

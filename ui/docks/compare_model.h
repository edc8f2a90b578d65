// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/race/race_lane.h"
#include "app/scene/window_needs.h"
#include "ui/widgets/checked_model.h"

namespace ui {

/// The algorithms of a race as a table, one a row: the columns' headings, texts and sort keys.
/// Forms without times were not measured: they have no numbers.
class CompareModel : public CheckedModel {
    Q_OBJECT

public:
    enum Column { Name, Lane, Filled, Hollow, Differ, Here };
    enum Role { OrderRole = Qt::UserRole };

    using CheckedModel::CheckedModel;
    /// Resets the model if the variants are others than before. `needs`: what the clip windows of
    /// the drawing demand of an algorithm; `limiting`: the name of the one window at which not all
    /// can clip, empty if there is none or more than one.
    void show(std::span<const app::RaceRow> rows, std::size_t lines,
              app::WindowNeeds needs = app::WindowNeeds::Rectangle, const QString& limiting = {});
    void setDigits(int digits);         ///< significant ones of times
    void setLaneShown(bool shown);      ///< else the columns of times say the unit
    void setInListsOrder(bool inOrder); ///< whether the table shows the rows in the model's order

    const app::RacePair& pair(int number) const { return pairs_[std::size_t(number)]; }
    const app::RaceLane& lane() const { return lane_; }
    std::size_t lines() const { return lines_; }
    bool timed() const; ///< the drawing has enough lines for meaningful times
    bool sortsBy(int column) const { return timed() || column < Lane || column > Hollow; }
    /// By differences, the largest come first.
    static Qt::SortOrder orderOf(int column)
    {
        return column == Differ ? Qt::DescendingOrder : Qt::AscendingOrder;
    }
    bool shows(clipping::Form form) const { return app::anyIn(pairs_, form); }
    app::WindowNeeds needs() const { return needs_; }
    /// Whether not every algorithm can clip at all of the windows.
    bool limits() const { return needs_ > app::WindowNeeds::RotatedRectangle; }
    int rowOf(const app::Variant& variant) const; ///< -1: the variant is in no row

protected:
    int rows() const override;
    int columns() const override;
    QVariant cell(int row, int column, int role) const override;
    QVariant heading(int column, int role) const override;

private:
    std::vector<app::RacePair> pairs_;
    app::RaceLane lane_;
    std::size_t lines_ = 0;
    app::WindowNeeds needs_ = app::WindowNeeds::Rectangle;
    QString limiting_;
    int digits_ = 3;
    bool inOrder_ = true, laneShown_ = true;
};

} // namespace ui

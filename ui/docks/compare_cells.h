// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/compare_model.h"
#include "ui/widgets/dense_table.h"

namespace ui {

/// Paints the cells of a table that shows a CompareModel, sorted.
class CompareCells : public QStyledItemDelegate {
    Q_OBJECT

public:
    CompareCells(const CompareModel& model, DenseTable& table);
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    /// Of the column of names: with the marker and the abbreviation alone.
    int leastNameWidth() const;

private:
    int abbreviationWidth() const; ///< of the longest one, and a gap
    void paintName(QPainter& painter, const QStyleOptionViewItem& option,
                   const app::RacePair& pair) const;
    void paintLane(QPainter& painter, const QStyleOptionViewItem& option,
                   const app::RacePair& pair) const;
    void paintNumber(QPainter& painter, const QStyleOptionViewItem& option,
                     const QModelIndex& index, const app::RacePair& pair) const;

    const CompareModel& model_;
    const DenseTable& table_;
};

} // namespace ui

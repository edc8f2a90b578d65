// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "ui/docks/compare_model.h"
#include "ui/widgets/dense_table.h"

#include <QElapsedTimer>
#include <QSortFilterProxyModel>

namespace ui {

/// The rows of a race, sorted by any column. What is chosen there, algorithm and form, is chosen in
/// the session. The order changes once a second at most. Where space is short it does without the
/// lines that are visible, the spread, and the sparkline, in this order.
class CompareTable : public DenseTable {
    Q_OBJECT

public:
    explicit CompareTable(app::Session& session, QWidget* parent = nullptr);

    void showRows(std::span<const app::RaceRow> rows, std::size_t lines);
    int heightFor(int rows) const; ///< with the header

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void choose(const QModelIndex& index);
    void follow();
    void sort();
    void showOrder();
    void fitColumns();
    int widthOf(int column) const;

    app::Session& session_;
    CompareModel model_;
    QSortFilterProxyModel sorted_;
    QElapsedTimer sinceSorted_;
    std::vector<int> widths_; ///< of one drawing they only grow, so that nothing jumps
    bool following_ = false;
};

} // namespace ui

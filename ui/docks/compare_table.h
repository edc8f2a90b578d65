// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "ui/docks/compare_model.h"
#include "ui/widgets/dense_table.h"

#include <QElapsedTimer>
#include <QSortFilterProxyModel>

namespace ui {

/// The rows of a race, sorted by any column. Selecting a row selects its algorithm and form in the
/// session. The order changes at most once a second. If space is short, the table drops the columns
/// for visible lines, spread and sparkline, in this order. A last column is shown only where not
/// every algorithm can clip at all clip windows: it says which can.
class CompareTable : public DenseTable {
    Q_OBJECT

public:
    explicit CompareTable(app::Session& session, QWidget* parent = nullptr);

    void showRows(std::span<const app::RaceRow> rows, std::size_t lines,
                  app::WindowNeeds needs = app::WindowNeeds::Rectangle);
    int heightFor(int rows) const; ///< includes the header; in logical pixels

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
    /// They only grow while the drawing is the same, so that nothing jumps.
    std::vector<int> widths_;
    bool following_ = false;
};

} // namespace ui

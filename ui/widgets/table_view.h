// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets/table_model.h"

#include <QSortFilterProxyModel>
#include <QTableView>

namespace ui {

/// Shows all rows of an experiment's table without scrolling vertically: no grid, numbers at the
/// right, algorithms with their markers (filled: corrected, hollow: as published), error counts in
/// the colour of differing lines. Copies the selection, or everything, as tab-separated text.
class TableView : public QTableView {
    Q_OBJECT

public:
    explicit TableView(QWidget* parent = nullptr);

    /// Sortable: a click on a heading sorts. SumIsLast: the last row sums up the others and is set
    /// apart.
    enum class Rows : std::uint8_t { Sortable, SumIsLast, Plain };
    void show(app::Table table, Rows rows);

    const app::Table& table() const { return model_.table(); }
    void copy() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();

    TableModel model_;
    QSortFilterProxyModel sorted_;
};

} // namespace ui

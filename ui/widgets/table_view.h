// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets/table_model.h"

#include <QSortFilterProxyModel>
#include <QTableView>

namespace ui {

/// Shows an experiment's table whole, as high as it is: no grid, numbers at the right, algorithms
/// with their markers (filled: corrected, hollow: as published), what is lost in the colour of what
/// differs. Copies what is selected, or all, as text with tabs.
class TableView : public QTableView {
    Q_OBJECT

public:
    explicit TableView(QWidget* parent = nullptr);

    /// Whether a click on a heading sorts; where the last row tells of all others, it is set apart.
    enum class Rows : std::uint8_t { Sortable, SumIsLast, Plain };
    void show(app::Table table, Rows rows);

    const app::Table& table() const { return model_.table(); }
    void copy() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();

    TableModel model_;
    QSortFilterProxyModel sorted_;
};

} // namespace ui

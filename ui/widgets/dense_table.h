// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QTableView>

namespace ui {

/// A table without a grid, with muted headings, in which whole rows are selected; an arrow marks
/// the sort column. The model's TextAlignmentRole aligns the texts. Ctrl+C copies the selected
/// rows, or the whole table if rows cannot be selected.
class DenseTable : public QTableView {
    Q_OBJECT

public:
    static constexpr int gap = 8; ///< at both sides of a text, in logical pixels
    /// Of a heading: two texts, painted at its left and right in place of its own.
    static constexpr int EndsRole = Qt::UserRole + 100;

    explicit DenseTable(QWidget* parent = nullptr);
    /// Paints a cell's background: selected and hovered rows have a uniform background, and the
    /// selected row has a ring while the table has the focus.
    void paintGround(QPainter& painter, const QStyleOptionViewItem& option,
                     const QModelIndex& index) const;

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    QRect cellsToCopy() const;
    void hover(int row);

    int hovered_ = -1;
};

} // namespace ui

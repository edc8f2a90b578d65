// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QTableView>

namespace ui {

/// A table without a grid whose rows are chosen as a whole, under muted headings; an arrow tells
/// what it is sorted by. Texts stand as the model's TextAlignmentRole says.
class DenseTable : public QTableView {
    Q_OBJECT

public:
    static constexpr int gap = 8; ///< at both sides of a text

    explicit DenseTable(QWidget* parent = nullptr);
    /// What is below a cell: a row that is chosen or under the pointer has one ground, and while
    /// the table has the focus the chosen one has a ring.
    void paintGround(QPainter& painter, const QStyleOptionViewItem& option,
                     const QModelIndex& index) const;

protected:
    bool viewportEvent(QEvent* event) override;

private:
    void hover(int row);

    int hovered_ = -1;
};

} // namespace ui

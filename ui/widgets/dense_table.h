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
    explicit DenseTable(QWidget* parent = nullptr);
    int hoveredRow() const { return hovered_; }

protected:
    bool viewportEvent(QEvent* event) override;

private:
    void hover(int row);

    int hovered_ = -1;
};

} // namespace ui

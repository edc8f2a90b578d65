// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/counted.h"

#include <QWidget>

#include <vector>

namespace ui {

/// The operations up to the current step and in total: "12 of 14 comparisons".
class OperationsView : public QWidget {
    Q_OBJECT

public:
    explicit OperationsView(QWidget* parent = nullptr);

    void show(const clipping::OperationCounts& now, const clipping::OperationCounts& all);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Cell {
        QString now, all, of, word;
    };
    /// Its width at the last step, so that nothing moves while stepping.
    int widthOf(const Cell& cell) const;
    std::vector<QPoint> places(int width) const;
    int cellHeight() const;

    std::vector<Cell> cells_;
};

} // namespace ui

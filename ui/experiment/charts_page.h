// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"

#include <QScrollArea>

class QVBoxLayout;

namespace ui {

class ChartView;

/// Charts one below the other, as wide as the page, up to a readable maximum width.
class ChartsPage : public QScrollArea {
    Q_OBJECT

public:
    explicit ChartsPage(QWidget* parent = nullptr);

    void show(std::vector<app::Chart> charts);

    /// The topmost chart whose middle is visible; null: none.
    const app::Chart* current() const;

signals:
    void exportWanted(const app::Chart& chart);

private:
    ChartView* viewOf(app::Chart chart);

    QVBoxLayout* column_;
    QList<ChartView*> views_;
};

} // namespace ui

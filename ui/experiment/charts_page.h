// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"

#include <QScrollArea>

class QVBoxLayout;

namespace ui {

class ChartView;

/// Charts one below the other, as wide as there is room but not wider than they can be read.
class ChartsPage : public QScrollArea {
    Q_OBJECT

public:
    explicit ChartsPage(QWidget* parent = nullptr);

    void show(std::vector<app::Chart> charts);

    /// The uppermost one that is in sight with its middle; null: there is none.
    const app::Chart* current() const;

signals:
    void exportWanted(const app::Chart& chart);

private:
    ChartView* viewOf(app::Chart chart);

    QVBoxLayout* column_;
    QList<ChartView*> views_;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/experiment/study.h"

#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QTabWidget>

#include <memory>

class QHBoxLayout;

namespace ui {

class ChartsPage;
class ChartView;
class Segments;
class TablesPage;

/// The results of a study: a verdict in plain sentences, and tabs with tables, charts, reasons for
/// the times, and the circumstances. One trial and one measure are shown at a time.
class Results : public QWidget {
    Q_OBJECT

public:
    /// `tools` are placed at the right of the tabs.
    explicit Results(const QList<QWidget*>& tools, QWidget* parent = nullptr);

    void show(std::shared_ptr<const app::Study> study);
    void markOld(); ///< marks the results as those of the previous run until new ones are shown
    const std::shared_ptr<const app::Study>& study() const { return study_; } ///< null: none yet

    /// The table or chart of the current tab; null: none.
    const app::Table* shownTable() const;
    const app::Chart* shownChart() const;
    void copyTable() const;

protected:
    void resizeEvent(QResizeEvent* event) override;

signals:
    void tabChanged();
    void exportWanted(const app::Chart& chart);

private:
    void addPages(const QList<QWidget*>& tools);
    void showMeasures();
    void showTrial();
    void showVerdict();
    void showReasons();
    void reserveRoom();
    const app::Trial& trial() const;
    const app::Measure& measure() const;

    std::shared_ptr<const app::Study> study_;
    QHBoxLayout* row_;
    QComboBox* trial_;
    Segments *measures_ = nullptr, *reasons_;
    QLabel *age_, *verdict_, *reason_;
    QScrollArea* summary_;
    QTabWidget* tabs_;
    ChartsPage* charts_;
    ChartView* reasonChart_;
    TablesPage *tables_, *why_, *circumstances_;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/race/live_race.h"
#include "app/session/session.h"

#include <QLabel>
#include <QWidget>

namespace ui {

class CompareTable;
class Segments;

/// Clips the same frame with every algorithm and shows times and operation counts. The race runs
/// only while the panel is visible.
class ComparePanel : public QWidget {
    Q_OBJECT

public:
    explicit ComparePanel(app::Session& session, QWidget* parent = nullptr);

    const app::LiveRace& race() const { return race_; }
    CompareTable& table() const { return *table_; }
    QString groups() const { return groups_->toolTip(); }
    QString field() const { return field_->text(); }

    void setWatched(bool watched);

    QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitGroups();
    void chooseForms(int index);
    void showRace();
    void followWindows();
    void showNothingMeasured();

    const app::Session& session_;
    app::LiveRace race_;
    Segments* forms_;
    CompareTable* table_;
    QLabel *state_, *groups_, *field_;
};

} // namespace ui

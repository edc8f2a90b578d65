// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/race/live_race.h"
#include "app/race/race_verdict.h"
#include "app/scene/window_needs.h"
#include "app/session/session.h"

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace ui {

class CompareTable;
class Segments;
class VerdictArea;
class VerdictList;

/// Clips the same frame with every algorithm: the times and differences as a table, and what
/// follows from them in words. The race runs only while the panel is visible. Numbers change at
/// most twice a second.
class ComparePanel : public QWidget {
    Q_OBJECT

public:
    explicit ComparePanel(app::Session& session, QWidget* parent = nullptr);

    const app::LiveRace& race() const { return race_; }
    CompareTable& table() const { return *table_; }
    const VerdictList& verdict() const { return *verdict_; }
    QString groups() const; ///< all groups of times that do not differ; the verdict's tooltip
    QString field() const { return field_->text(); }
    QString place() const { return place_->text(); }

    void setWatched(bool watched);

    QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QLayout* choiceRow();
    QLayout* legendRow();
    void chooseForms(int index);
    void followRace();
    void showRace();
    void showAgain();
    void judge(std::span<const app::RaceRow> rows, std::size_t lines);
    void show(std::span<const app::RaceRow> rows, std::size_t lines);
    void followWindows();
    void showNothingMeasured();
    void fitRows();
    int usualVerdict() const;

    const app::Session& session_;
    app::LiveRace race_;
    Segments* forms_;
    QPushButton* sort_;
    CompareTable* table_;
    QLabel *state_, *field_, *place_;
    QWidget* page_;                   ///< the caption that says where, if no window's name does
    QWidget *corrected_, *published_; ///< parts of the legend
    VerdictList* verdict_;
    VerdictArea* verdictArea_;
    std::vector<app::NamedNeeds> windows_{}; ///< as shown
    QString where_{};
    /// A verdict that knows which times tie.
    struct Ranked {
        std::vector<app::RaceStatement> statements;
        QString groups;
    };
    app::Background<Ranked> ranking_;
    QTimer pause_;         ///< until the numbers may change again
    bool waiting_ = false; ///< newer ones
};

} // namespace ui

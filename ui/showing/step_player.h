// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/showing/step_beats.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <memory>

namespace ui {

class Actor;
class MainWindow;
class ShowBar;

/// Performs steps in a window, at a pace that can be followed. Meanwhile the person's mouse and
/// keyboard do nothing there: a click or Esc ends it, Enter goes on.
class StepPlayer : public QObject {
    Q_OBJECT

public:
    /// Belongs to the window.
    StepPlayer(MainWindow& window, std::vector<app::ShownStep> steps);
    ~StepPlayer() override;

    void begin(); ///< fits the page into the window
    /// Performs what is left of the step at once; between two steps, begins the next one.
    void next();
    void stop();
    bool isPlaying() const { return playing_; }
    std::size_t step() const { return step_; } ///< from 0; the one that is, or was, performed

signals:
    void stepDone();
    void ended(bool wholly); ///< all steps were performed

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void beginStep();
    void goOn();
    void act();
    bool isPersonsTurn() const;
    void finish(bool wholly);
    void obey(int key); ///< of the person

    MainWindow& window_;
    std::vector<app::ShownStep> steps_;
    std::size_t step_ = 0;
    bool playing_ = false;
    bool acts_ = false;      ///< the events that come now are the actor's
    std::deque<Beat> beats_; ///< of the step that is performed; empty: between two steps
    QTimer timer_;
    std::unique_ptr<Actor> actor_;
    QPointer<ShowBar> bar_;
};

} // namespace ui

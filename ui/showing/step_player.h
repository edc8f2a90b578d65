// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/shown_steps.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <deque>
#include <functional>

class QAction;

namespace ui {

class MainWindow;
class PointerMark;
class ShowBar;

/// Performs steps in a window by events of the pointer and the keyboard, at a pace that can be
/// followed. Meanwhile the person's own do nothing there: a click or Esc ends it, Enter goes on.
class StepPlayer : public QObject {
    Q_OBJECT

public:
    /// Belongs to the window. The drawing is fitted into it, and nothing is selected.
    StepPlayer(MainWindow& window, std::vector<app::ShownStep> steps);
    ~StepPlayer() override;

    void begin();
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
    /// A part of a step, and the milliseconds that pass before it.
    struct Beat {
        int wait;
        std::function<void()> act;
    };

    void beginStep();
    void goOn();
    void act();
    void finish(bool wholly);
    void add(const app::ShownStep& step);
    enum class Over : std::uint8_t { Drawing, Bars };
    void addWay(const app::Point& to, Qt::MouseButtons buttons, Qt::KeyboardModifiers with,
                Over over = Over::Drawing);
    void addPress(Qt::KeyboardModifiers with, QEvent::Type type);
    void addRelease(Qt::KeyboardModifiers with);
    void markPlace(bool pressed);
    void point(QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons buttons,
               Qt::KeyboardModifiers with);
    void addButton(const QString& name);
    void press(const app::ShownStep::Key& key);
    app::Point inDrawing(const app::Point& millimetres) const;

    MainWindow& window_;
    std::vector<app::ShownStep> steps_;
    std::size_t step_ = 0;
    bool playing_ = false;
    std::deque<Beat> beats_; ///< of the step that is performed; empty: between two steps
    QTimer timer_;
    app::Point at_{}, aim_{}; ///< of the pointer: now, and after the beats; in the drawing
    Qt::MouseButtons down_{};
    QPointer<ShowBar> bar_;
    QPointer<PointerMark> mark_;
};

/// What a step does, for a person: "Rectangle (R)".
QString wordsFor(const MainWindow& window, const app::ShownStep& step);
/// The command of this name that steps may run; null: there is none.
QAction* commandToShow(MainWindow& window, const QString& key);

} // namespace ui

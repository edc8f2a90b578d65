// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/experiment/choice.h"
#include "app/experiment/study.h"
#include "app/session/session.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/message_strip.h"

#include <QDialog>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>

namespace ui {

class ChoicePanel;
class Exports;
class ProgressRow;
class Results;

/// Repeats the paper's experiment and similar ones: the choices at the left, the results at the
/// right, progress below. Not modal: the editor stays usable. Closing the window stops the
/// measurement.
class ExperimentWindow : public QDialog {
    Q_OBJECT

public:
    /// `name` returns the drawing's name.
    ExperimentWindow(app::Session& session, std::function<QString()> name,
                     QWidget* parent = nullptr);
    ~ExperimentWindow() override;

    /// Replaces the dialogs; used by tests.
    void setQuestions(std::unique_ptr<Questions> questions);
    /// The program that makes each run if they are made in new processes; used by tests, which are
    /// not Clearcut.
    void setProgram(const QString& path) { program_ = path; }
    const app::Study* study() const;

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* left();
    QWidget* right();
    void layOut();
    void addTools();
    void run(app::Choice choice);
    void cancel();
    void finish(app::Result<app::Study> study);
    void showProgress(const app::Progress& progress);
    void showEffort();
    void showState();
    void followDrawing();

    app::Session& session_;
    std::function<QString()> name_;
    Exports* exports_;
    ChoicePanel* choice_;
    QPushButton *run_, *quick_, *copy_;
    QToolButton* export_;
    QLabel* effort_;
    ProgressRow* progress_;
    MessageStrip* strip_;
    QStackedWidget* stack_;
    Results* results_;
    QString program_;
    QElapsedTimer taken_;
    double thought_ = 0;       ///< expected duration of the run, in seconds
    double durationRatio_ = 1; ///< measured divided by expected duration; kept in the settings
    app::Background<app::Result<app::Study>> measuring_;
};

} // namespace ui

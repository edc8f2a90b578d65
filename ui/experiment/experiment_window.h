// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/choice.h"
#include "app/session/session.h"
#include "ui/dialogs/questions.h"
#include "ui/experiment/measuring.h"
#include "ui/widgets/message_strip.h"

#include <QDialog>
#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>

namespace ui {

class ChoicePanel;
class Exports;
class Results;

/// Repeats the paper's experiment, and others like it: what is measured at the left, what came out
/// at the right, progress below. The editor stays usable meanwhile. Closing it stops the measuring.
class ExperimentWindow : public QDialog {
    Q_OBJECT

public:
    /// `name` tells what the drawing is called.
    ExperimentWindow(app::Session& session, std::function<QString()> name,
                     QWidget* parent = nullptr);
    ~ExperimentWindow() override;

    /// What answers instead of dialogs (tests).
    void setQuestions(std::unique_ptr<Questions> questions);
    const app::Study* study() const;

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* left();
    QWidget* right();
    QWidget* below();
    void layOut();
    void addTools();
    void run(app::Choice choice);
    void cancel();
    void finish(const std::shared_ptr<const app::Study>& study);
    void showProgress(const app::Progress& progress);
    void showEffort();
    void showState();
    void followDrawing();

    app::Session& session_;
    std::function<QString()> name_;
    Exports* exports_;
    ChoicePanel* choice_;
    QPushButton *run_, *quick_, *cancel_, *copy_;
    QToolButton* export_;
    QLabel *effort_, *state_;
    QProgressBar* bar_;
    MessageStrip* strip_;
    QStackedWidget* stack_;
    Results* results_;
    QElapsedTimer taken_;
    double thought_ = 0; ///< seconds that the run was expected to take
    double pace_ = 1; ///< time taken by time thought; from the settings
    Measuring measuring_;
};

/// Shows the window that belongs to that one; there is one at most.
class MainWindow;
void showExperiment(MainWindow& window);

} // namespace ui

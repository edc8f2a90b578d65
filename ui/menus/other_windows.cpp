// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/other_windows.h"

#include "ui/experiment/experiment_window.h"
#include "ui/explanation/explanation_window.h"
#include "ui/files/files.h"
#include "ui/hard_cases/hard_cases_window.h"
#include "ui/judge/judge_window.h"
#include "ui/menus/palette.h"
#include "ui/microscope/export_steps.h"
#include "ui/window/main_window.h"

#include <QStatusBar>

namespace ui {

namespace {

void bringToFront(QDialog& dialog)
{
    dialog.show();
    dialog.raise();
    dialog.activateWindow();
}

} // namespace

OtherWindows::OtherWindows(MainWindow& window) : QObject(&window), window_(window)
{
    connect(&window, &MainWindow::experimentWanted, this, &OtherWindows::showExperiment);
    connect(&window, &MainWindow::explanationWanted, this, &OtherWindows::explain);
    connect(&window, &MainWindow::stepsExportWanted, this, &OtherWindows::exportSteps);
}

void OtherWindows::showExperiment()
{
    if (!experiment_)
        experiment_ = new ExperimentWindow(
            window_.session(), [this] { return window_.files().name(); }, &window_);
    bringToFront(*experiment_);
}

void OtherWindows::showHardCases()
{
    if (!hardCases_)
        hardCases_ = new HardCasesWindow(window_.session(), window_.files(), window_);
    bringToFront(*hardCases_);
}

void OtherWindows::showJudge()
{
    if (!judge_)
        judge_ = new JudgeWindow(window_.session(), &window_);
    bringToFront(*judge_);
}

ExplanationWindow& OtherWindows::reader()
{
    if (!explanation_) {
        explanation_ = new ExplanationWindow(window_.session(), window_);
        connect(explanation_, &ExplanationWindow::hardCaseWanted, this,
                [this](const app::HardCase& hard) {
                    showHardCases();
                    hardCases_->choose(hard);
                });
        connect(explanation_, &ExplanationWindow::failingWanted, this,
                [this](const QString& variant) {
                    showHardCases();
                    hardCases_->chooseFailing(variant);
                });
    }
    return *explanation_;
}

void OtherWindows::explain(const clipping::Algorithm& algorithm)
{
    reader().show(algorithm);
    bringToFront(*explanation_);
}

void OtherWindows::showManual()
{
    reader().showManual();
    bringToFront(*explanation_);
}

void OtherWindows::showManual(const QString& topic)
{
    reader().showManual(topic);
    bringToFront(*explanation_);
}

void OtherWindows::showPalette()
{
    if (!palette_) {
        palette_ = new Palette(window_, *this);
        connect(palette_, &Palette::refused, &window_, [this](const QString& reason) {
            window_.statusBar()->showMessage(reason, MainWindow::messageMilliseconds);
        });
    }
    palette_->open();
}

void OtherWindows::explainCurrent()
{
    const app::Session& session = window_.session();
    explain(session.microscope.isOpen() ? *session.microscope.tracedLine().variant.algorithm
                                        : *session.display().variant.algorithm);
}

void OtherWindows::exportSteps()
{
    if (!stepExports_) {
        stepExports_ = new StepExports(window_, window_.session().microscope);
        connect(stepExports_, &StepExports::told, &window_, &MainWindow::tell);
    }
    stepExports_->ask();
}

} // namespace ui

#include "moc_other_windows.cpp"

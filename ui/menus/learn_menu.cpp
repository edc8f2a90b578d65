// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/explanation/explanation_window.h"
#include "ui/hard_cases/hard_cases_window.h"
#include "ui/judge/judge_window.h"
#include "ui/menus/actions.h"
#include "ui/microscope/export_steps.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>

namespace ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("LearnMenu", text); }

void toggleMicroscope(MainWindow& window)
{
    app::Session& session = window.session();
    if (session.microscope.isOpen())
        session.microscope.close();
    else
        window.drawnLine().look();
}

void exportSteps(MainWindow& window)
{
    auto* exports = window.findChild<StepExports*>();
    if (!exports) {
        exports = new StepExports(window, window.session().microscope);
        QObject::connect(exports, &StepExports::told, &window, &MainWindow::tell);
    }
    exports->ask();
}

void toggleOverlay(MainWindow& window)
{
    app::Display display = window.session().display();
    display.overlay = !display.overlay;
    window.session().setDisplay(display);
}

} // namespace

// NOLINTNEXTLINE(readability-function-size): a table, a row for each entry
MenuInfo learnMenu()
{
    return {tr("&Learn"),
            {
                {"microscope",
                 tr("Clip &microscope"),
                 {QKeySequence("F2")},
                 Reach::Window,
                 "microscope",
                 toggleMicroscope,
                 nullptr,
                 [](const MainWindow& w) { return w.session().microscope.isOpen(); }},
                {"export-steps",
                 tr("Export s&teps…"),
                 {},
                 Reach::Window,
                 "export",
                 exportSteps,
                 [](const MainWindow& w) { return w.session().microscope.isOpen(); }},
                {"overlay",
                 tr("What the algorithm &sees"),
                 {QKeySequence("F3"), QKeySequence("Ctrl+R")},
                 Reach::Window,
                 "regions",
                 toggleOverlay,
                 nullptr,
                 [](const MainWindow& w) { return w.session().display().overlay; }},
                {"lessons",
                 tr("&Lessons"),
                 {QKeySequence("Ctrl+F1")},
                 Reach::Window,
                 "book",
                 [](MainWindow& w) { w.showLessons(); },
                 nullptr,
                 [](const MainWindow& w) { return w.showsLessons(); }},
                {"cost-map",
                 tr("&Cost map"),
                 {QKeySequence("Shift+F2")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.togglePanel("cost-map"); },
                 nullptr,
                 [](const MainWindow& w) { return w.showsPanel("cost-map"); }},
                {"exactness",
                 tr("E&xactness"),
                 {QKeySequence("Shift+F3")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.togglePanel("exactness"); },
                 nullptr,
                 [](const MainWindow& w) { return w.showsPanel("exactness"); }},
                {"about-algorithm", tr("About this &algorithm"),
                 keys(QKeySequence::HelpContents, {QKeySequence("F1")}), Reach::Window, "book",
                 [](MainWindow& w) { showExplanation(w); }},
                {"hard-cases",
                 tr("&Hard cases…"),
                 {QKeySequence("Ctrl+F2")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { showHardCases(w); }},
                {"judge",
                 tr("&Judge your own algorithm…"),
                 {QKeySequence("Ctrl+F3")},
                 Reach::Window,
                 {},
                 showJudge},
            }};
}

} // namespace ui

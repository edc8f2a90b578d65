// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/other_windows.h"

#include "app/base/text.h"
#include "app/teaching/manual.h"
#include "ui/experiment/experiment_window.h"
#include "ui/explanation/explanation_window.h"
#include "ui/files/files.h"
#include "ui/hard_cases/hard_cases_window.h"
#include "ui/judge/judge_window.h"
#include "ui/lessons/lesson_export.h"
#include "ui/menus/palette.h"
#include "ui/microscope/export_steps.h"
#include "ui/sheets/command_keys.h"
#include "ui/showing/show_steps.h"
#include "ui/tiles/tiles_page.h"
#include "ui/widgets/sheet.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QShortcut>
#include <QStatusBar>

#include <utility>

namespace ui {

namespace {

void bringToFront(QDialog& dialog)
{
    dialog.show();
    dialog.raise();
    dialog.activateWindow();
}

/// The command that shows or takes what is in hand.
QString commandInHand(const MainWindow& window)
{
    QWidget* const focused = QApplication::focusWidget();
    if (const Sheet* sheet = window.sheet(); sheet && focused && sheet->isAncestorOf(focused))
        return sheet->objectName();
    for (const QWidget* around = focused; around; around = around->parentWidget())
        if (qobject_cast<const Dock*>(around))
            return around->objectName() == QStringLiteral("start")
                       ? around->objectName()
                       : QStringLiteral("panel-") + around->objectName();
    if (window.showsLessons())
        return QStringLiteral("lessons");
    if (window.session().microscope.isOpen())
        return QStringLiteral("microscope");
    if (window.tilesPage() && window.tilesPage()->isVisible())
        return QStringLiteral("tiles");
    return QStringLiteral("tool-") + app::latin(window.canvas().tool());
}

app::HelpCommands helpCommands(MainWindow& window)
{
    app::HelpCommands all;
    const app::KeyTable& table = CommandKeys::of(window).table();
    for (std::size_t i = 0; i < table.commands().size(); ++i) {
        app::HelpCommand command{table.commands()[i].name, {}};
        for (const QKeySequence& keys : table.keys(i))
            command.keys << keys.toString(QKeySequence::NativeText);
        all[table.commands()[i].key] = command;
    }
    return all;
}

} // namespace

OtherWindows::OtherWindows(MainWindow& window) : QObject(&window), window_(window)
{
    connect(&window, &MainWindow::experimentWanted, this, &OtherWindows::showExperiment);
    connect(&window, &MainWindow::explanationWanted, this, &OtherWindows::explain);
    connect(&window, &MainWindow::stepsExportWanted, this, &OtherWindows::exportSteps);
    connect(&window, &MainWindow::lessonExportWanted, this, &OtherWindows::exportLesson);
    window.installEventFilter(this);
}

void OtherWindows::showExperiment()
{
    if (!experiment_) {
        experiment_ = new ExperimentWindow(
            window_.session(), [this] { return window_.files().name(); }, &window_);
        addHelp(*experiment_, QStringLiteral("reproduce-paper"));
    }
    bringToFront(*experiment_);
}

void OtherWindows::showHardCases()
{
    if (!hardCases_) {
        hardCases_ = new HardCasesWindow(window_.session(), window_.files(), window_);
        addHelp(*hardCases_, QStringLiteral("hard-cases"));
        connect(hardCases_, &HardCasesWindow::editorWanted, &window_, &MainWindow::comeToFront);
    }
    bringToFront(*hardCases_);
}

void OtherWindows::showJudge()
{
    if (!judge_) {
        judge_ = new JudgeWindow(window_.session(), &window_);
        addHelp(*judge_, QStringLiteral("judge"));
    }
    bringToFront(*judge_);
}

/// F1 in another window shows the page of the command that opens it.
void OtherWindows::addHelp(QWidget& other, const QString& command)
{
    connect(new QShortcut(Qt::Key_F1, &other), &QShortcut::activated, this,
            [this, command] { showManual(app::topicExplaining(command)); });
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
        connect(explanation_, &ExplanationWindow::showWanted, this, &OtherWindows::showSteps);
        connect(explanation_, &ExplanationWindow::editorWanted, &window_, &MainWindow::comeToFront);
        connect(&window_.canvas(), &Canvas::toolChanged, explanation_,
                [this] { explanation_->takeInHand(app::topicExplaining(commandInHand(window_))); });
    }
    explanation_->setCommands(helpCommands(window_));
    return *explanation_;
}

/// Where the help would cover them it waits until this drawing is in front again.
void OtherWindows::showSteps(const app::ManualPage& page)
{
    if (const QString why = ui::showSteps(window_, page); !why.isEmpty())
        return explanation_->tell(why);
    helpWaits_ = !window_.isVisible()
                 && explanation_->frameGeometry().intersects(window_.window()->frameGeometry());
    if (helpWaits_)
        explanation_->hide();
}

bool OtherWindows::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &window_ && event->type() == QEvent::Show && std::exchange(helpWaits_, false))
        QMetaObject::invokeMethod(explanation_, &QWidget::show, Qt::QueuedConnection);
    return QObject::eventFilter(watched, event);
}

void OtherWindows::help()
{
    reader().showInHand(app::topicExplaining(commandInHand(window_)));
    bringToFront(*explanation_);
}

void OtherWindows::explain(const clipping::Algorithm& algorithm)
{
    reader().show(algorithm);
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

void OtherWindows::exportLesson()
{
    if (!lessonExport_) {
        lessonExport_ = new LessonExport(window_, window_.session().course);
        connect(lessonExport_, &LessonExport::told, &window_, &MainWindow::tell);
    }
    lessonExport_->ask();
}

} // namespace ui

#include "moc_other_windows.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QObject>

namespace app {
struct ManualPage;
}

namespace ui {

class ExperimentWindow;
class ExplanationWindow;
class HardCasesWindow;
class JudgeWindow;
class LessonExport;
class MainWindow;
class Palette;
class StepExports;

/// The windows beside the main window, which asks for some of them by its signals. Each is made
/// when it is first shown, and is kept as long as the main window.
class OtherWindows : public QObject {
    Q_OBJECT

public:
    explicit OtherWindows(MainWindow& window); ///< belongs to the main window

    void showExperiment();
    void showHardCases();
    void showJudge();
    void explain(const clipping::Algorithm& algorithm);
    void showManual(const QString& topic); ///< its page
    /// The page of what is in hand: the sheet or the panel with the focus, the microscope, the
    /// tiles, or the tool.
    void help();
    void showPalette();
    /// Explains the algorithm of the open microscope, else the one that clips.
    void explainCurrent();
    /// Opens the export dialog for the microscope's trace.
    void exportSteps();
    void exportLesson(); ///< the one in progress

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addHelp(QWidget& other, const QString& command);
    ExplanationWindow& reader();
    void showSteps(const app::ManualPage& page);

    MainWindow& window_;
    ExperimentWindow* experiment_ = nullptr;
    HardCasesWindow* hardCases_ = nullptr;
    JudgeWindow* judge_ = nullptr;
    ExplanationWindow* explanation_ = nullptr;
    bool helpWaits_ = false; ///< it is hidden while steps are shown in another drawing
    StepExports* stepExports_ = nullptr;
    LessonExport* lessonExport_ = nullptr;
    Palette* palette_ = nullptr;
};

} // namespace ui

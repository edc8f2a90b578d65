// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/option_bar.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/start_panel.h"
#include "ui/experiment/experiment_window.h"
#include "ui/explanation/explanation_window.h"
#include "ui/microscope/export_steps.h"
#include "ui/microscope/microscope_page.h"

#include <QSignalSpy>
#include <QToolButton>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace menus_other_windows_test {

using namespace ui;

namespace {

template <class Window>
bool shows(const MainWindow& window)
{
    const auto* opened = window.findChild<Window*>();
    return opened && opened->isVisible();
}

} // namespace

/// What the parts of the window ask for, and rooms above it carry out.
class OtherWindowsTest : public QObject {
    Q_OBJECT

private slots:
    void aPageAboutAnAlgorithmIsOpened()
    {
        TestWindow t;
        t.show();
        emit t.window->algorithmPanel().aboutWanted(clipping::algorithms()[2]);
        QVERIFY(shows<ExplanationWindow>(*t.window));
    }
    void theMicroscopeOpensPagesAndTheExportOfItsSteps()
    {
        TestWindow t;
        t.show();
        t.action("microscope")->trigger();
        emit t.window->microscopePage()->aboutWanted(&clipping::algorithms()[2]);
        QVERIFY(shows<ExplanationWindow>(*t.window));
        emit t.window->microscopePage()->exportWanted();
        QVERIFY(shows<ExportStepsDialog>(*t.window));
    }
    void thePanelStartOpensTheExperiment()
    {
        TestWindow t;
        t.show();
        emit t.window->findChild<StartPanel*>()->paperWanted();
        QVERIFY(shows<ExperimentWindow>(*t.window));
    }
    void theOptionBarHasItsCommands()
    {
        TestWindow t;
        t.show();
        const auto commands = t.window->optionBar().actions();
        QCOMPARE(commands.value(0), t.action("undo"));
        QCOMPARE(commands.value(1), t.action("redo"));
        int exports = 0;
        for (const auto* button : t.window->optionBar().findChildren<QToolButton*>())
            exports += button->defaultAction() == t.action("export");
        QCOMPARE(exports, 1);
    }
    void aWindowWithoutMenusOnlyAsks()
    {
        const TestWindow settings;
        MainWindow window(Backend::Raster);
        const QSignalSpy asked(&window, &MainWindow::explanationWanted);
        emit window.algorithmPanel().aboutWanted(clipping::algorithms()[2]);
        QCOMPARE(asked.size(), 1);
        QVERIFY(!window.findChild<ExplanationWindow*>());
    }
};

} // namespace menus_other_windows_test

TEST_CLASS(menus_other_windows_test::OtherWindowsTest, Widgets)
#include "tests/ui/menus/other_windows_test.moc"

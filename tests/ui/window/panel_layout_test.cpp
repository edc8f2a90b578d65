// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_layout.h"

#include <QAction>
#include <QSignalSpy>
#include <QToolButton>

#include "tests/test_class.h"
#include "tests/ui/window/plain_panels.h"

namespace window_panel_layout_test {

using namespace ui;

namespace {

/// Of the usual workspace, in the order of the docks.
const QStringList stack{"algorithm", "window", "selection", "line", "layers"};

/// Where the panels in front are.
QMap<QString, QRect> places(const PlainWindow& plain)
{
    QMap<QString, QRect> places;
    const QStringList front = plain.inFront();
    for (const Dock* dock : plain.docks.all())
        if (front.contains(dock->objectName()))
            places[dock->objectName()] = dock->geometry();
    return places;
}

} // namespace

class PanelLayoutTest : public QObject {
    Q_OBJECT

private slots:
    void aHighWindowStacksThePanelsAndALowOneHasTabs()
    {
        PlainWindow plain;
        plain.show();
        QCOMPARE(plain.inFront(), stack);
        plain.window.resize(1280, 700);
        plain.layout->fitWindow();
        QCOMPARE(plain.inFront(), QStringList("algorithm"));
        QCOMPARE(plain.window.tabifiedDockWidgets(plain.docks.algorithm).size(), 4);
        QTRY_VERIFY(plain.docks.algorithm->titleBarWidget()->height() == 0); // the tab is the title
    }
    void panelsThatAreTooHighShareTheLowestPlace()
    {
        PlainWindow plain;
        plain.show();
        PlainWindow::panel(plain.dock("layers")).least = 600;
        plain.layout->fit();
        QVERIFY(
            plain.window.tabifiedDockWidgets(&plain.dock("layers")).contains(&plain.dock("line")));
        QVERIFY(plain.window.tabifiedDockWidgets(plain.docks.algorithm).empty());
        QVERIFY(plain.inFront().contains("algorithm"));
    }
    void everyWorkspaceShowsItsPanels()
    {
        for (const Workspace& workspace : workspaces()) {
            PlainWindow plain;
            plain.show();
            plain.layout->choose(workspace);
            QStringList front = plain.inFront();
            if (!workspace.wide.isEmpty()) {
                QVERIFY(front.contains(workspace.wide));
                QVERIFY(front.contains(workspace.column[1]));
                continue;
            }
            QStringList wanted = workspace.column;
            front.sort();
            wanted.sort();
            QCOMPARE(front, wanted);
            QCOMPARE(plain.docks.algorithm->isFolded(), workspace.folds);
        }
    }
    void aFoldedPanelIsOnlyItsTitle()
    {
        PlainWindow plain;
        plain.show();
        plain.layout->choose(findWorkspace("workspace-draw"));
        QCoreApplication::processEvents();
        Dock& algorithm = *plain.docks.algorithm;
        QCOMPARE(algorithm.height(), algorithm.titleBarWidget()->height());
        QTest::mouseClick(algorithm.titleBarWidget()->findChild<QToolButton*>(), Qt::LeftButton);
        QVERIFY(!algorithm.isFolded());
        QTRY_VERIFY(algorithm.height() > 60);
        plain.layout->choose(findWorkspace("workspace-cut"));
        plain.layout->choose(findWorkspace("workspace-draw"));
        QVERIFY(algorithm.isFolded());
        plain.layout->raise("algorithm"); // somebody asks for it
        QVERIFY(!algorithm.isFolded());
    }
    void aFurtherPanelSharesTheLowestPlace()
    {
        PlainWindow plain;
        plain.show();
        plain.dock("history").toggleViewAction()->trigger();
        QVERIFY(plain.inFront().contains("history"));
        QVERIFY(plain.window.tabifiedDockWidgets(&plain.dock("history"))
                    .contains(&plain.dock("selection")));
    }
    void everyWorkspaceHasItsOwnLayoutAndIsRemembered()
    {
        PlainWindow plain;
        plain.show();
        const Workspace &draw = findWorkspace("workspace-draw"),
                        &cut = findWorkspace("workspace-cut");
        plain.layout->choose(draw);
        plain.window.addDockWidget(Qt::LeftDockWidgetArea, &plain.dock("layers"));
        plain.layout->choose(cut);
        QCOMPARE(plain.window.dockWidgetArea(&plain.dock("layers")), Qt::RightDockWidgetArea);
        plain.layout->choose(draw);
        QCOMPARE(plain.window.dockWidgetArea(&plain.dock("layers")), Qt::LeftDockWidgetArea);
        QCOMPARE(QSettings().value("workspace").toString(), "workspace-draw"); // at once
        plain.layout->save();
        PlainWindow next;
        QSettings().setValue("workspace", "workspace-draw");
        next.show();
        QCOMPARE(&next.layout->workspace(), &draw);
    }
    void startIsInFrontUntilItIsLeft()
    {
        PlainWindow plain;
        plain.show();
        plain.layout->showStart();
        QCOMPARE(plain.inFront(), QStringList("start"));
        plain.layout->leaveStart();
        QCOMPARE(plain.inFront(), stack);
        plain.layout->raise("start");
        QCOMPARE(plain.inFront(), QStringList("start"));
    }
    void aComparisonPanelIsAboveTheOthersAndWider()
    {
        PlainWindow plain;
        plain.show();
        const QSignalSpy changed(plain.layout.get(), &PanelLayout::changed);
        const auto before = places(plain);
        plain.layout->toggle("difference");
        QVERIFY(plain.layout->shows("difference") && !plain.layout->shows("compare"));
        QCOMPARE(plain.inFront(), QStringList({"window", "difference"}));
        QVERIFY(plain.docks.wide[1]->width() > before["algorithm"].width() + 100);
        QVERIFY(plain.docks.wide[1]->y() < plain.dock("window").y());
        plain.layout->toggle("difference");
        QCOMPARE(places(plain), before);
        QCOMPARE(changed.size(), 2);
    }
    void aComparisonPanelBehindAnotherComesToTheFront()
    {
        PlainWindow plain;
        plain.show();
        plain.layout->toggle("compare");
        plain.layout->toggle("difference");
        QVERIFY(!plain.inFront().contains("compare"));
        plain.layout->toggle("compare");
        QVERIFY(plain.layout->shows("compare") && plain.inFront().contains("compare"));
        plain.layout->toggle("compare");
        QVERIFY(!plain.layout->shows("compare"));
    }
    void raisingAPanelSaysSoBefore()
    {
        PlainWindow plain;
        plain.show();
        const QSignalSpy asked(plain.layout.get(), &PanelLayout::aboutToRaise);
        plain.layout->raise("layers");
        plain.layout->toggle("compare");
        QCOMPARE(asked.size(), 2);
    }
    void hiddenPanelsComeBackAsTheyWere()
    {
        PlainWindow plain;
        plain.show();
        const auto stacked = places(plain);
        plain.layout->hideAll();
        QCOMPARE(plain.inFront(), QStringList());
        for (const QAction* toggle : plain.layout->toggles())
            QVERIFY(!toggle->isEnabled());
        plain.layout->bringBack();
        QCOMPARE(places(plain), stacked);
        for (const QAction* toggle : plain.layout->toggles())
            QVERIFY(toggle->isEnabled());
    }
    /// Their places are higher than they are, by the height of the tab bars above them.
    void hiddenPanelsInTabsComeBackAsTheyWere()
    {
        PlainWindow plain;
        plain.show();
        plain.layout->toggle("compare");
        plain.layout->raise("layers");
        plain.window.resizeDocks({plain.docks.wide[0], &plain.dock("layers")}, {300, 500},
                                 Qt::Vertical);
        QCoreApplication::processEvents();
        const auto before = places(plain);
        QCOMPARE(before.keys(), QStringList({"compare", "layers"}));
        plain.layout->hideAll();
        QCoreApplication::processEvents();
        plain.layout->bringBack();
        QCOMPARE(places(plain), before);
    }
    void whilePanelsAreHiddenNothingIsArranged()
    {
        PlainWindow plain;
        plain.show();
        plain.layout->hideAll();
        plain.layout->showStart();
        plain.layout->reset();
        plain.window.resize(1280, 700);
        plain.layout->fitWindow();
        QCOMPARE(plain.inFront(), QStringList());
        plain.layout->bringBack();
        QCOMPARE(plain.inFront(), QStringList("start"));
    }
    void panelsAskedForWhileAllAreHiddenAreShownWhenTheyComeBack()
    {
        PlainWindow plain;
        plain.show();
        plain.window.resize(1280, 700);
        plain.layout->fitWindow();
        QCOMPARE(plain.inFront(), QStringList("algorithm"));
        plain.layout->hideAll();
        plain.layout->toggle("compare");
        plain.layout->raise("line");
        QCOMPARE(plain.inFront(), QStringList());
        QVERIFY(!plain.layout->shows("compare") && !plain.layout->shows("line"));
        plain.layout->bringBack();
        QCOMPARE(plain.inFront(), QStringList({"line", "compare"}));
        plain.layout->toggle("compare"); // it is known to be open
        QCOMPARE(plain.inFront(), QStringList("algorithm"));
        plain.layout->hideAll();
        plain.layout->bringBack();
        QCOMPARE(plain.inFront(), QStringList("algorithm")); // asked for once
    }
    void aPanelToggledTwiceWhileAllAreHiddenStaysClosed()
    {
        PlainWindow plain;
        plain.show();
        plain.layout->hideAll();
        plain.layout->toggle("compare");
        plain.layout->toggle("compare");
        plain.layout->bringBack();
        QCOMPARE(plain.inFront(), stack);
    }
    void raisingAComparisonPanelOpensItOnce()
    {
        PlainWindow plain;
        plain.show();
        plain.layout->raise("difference");
        plain.layout->raise("difference");
        QVERIFY(plain.inFront().contains("difference"));
        plain.layout->hideAll();
        plain.layout->raise("compare");
        plain.layout->raise("compare");
        QCOMPARE(plain.inFront(), QStringList());
        plain.layout->bringBack();
        QVERIFY(plain.inFront().contains("compare"));
    }
    void theLayoutIsResetWhenHiddenPanelsComeBack()
    {
        PlainWindow plain;
        plain.show();
        plain.window.addDockWidget(Qt::LeftDockWidgetArea, &plain.dock("layers"));
        plain.layout->hideAll();
        plain.layout->reset();
        plain.layout->bringBack();
        QCOMPARE(plain.window.dockWidgetArea(&plain.dock("layers")), Qt::RightDockWidgetArea);
        QCOMPARE(plain.inFront(), stack);
    }
    void startLeftWhileAllAreHiddenShowsNoPanel()
    {
        PlainWindow plain;
        plain.show();
        plain.window.resize(1280, 700); // tabs
        plain.layout->fitWindow();
        plain.layout->raise("layers");
        plain.layout->hideAll();
        plain.layout->raise("start");
        plain.layout->leaveStart();
        QCOMPARE(plain.inFront(), QStringList());
        plain.layout->bringBack();
        QCOMPARE(plain.inFront(), QStringList("layers"));
    }
    void panelsAreAskedForTheirHeightBeforeTheyComeBack()
    {
        PlainWindow plain;
        plain.show();
        bool hidden = false;
        connect(plain.layout.get(), &PanelLayout::aboutToBringBack, this,
                [&] { hidden = plain.dock("line").isHidden(); });
        plain.layout->bringBack();
        QVERIFY(!hidden); // they are not hidden: no signal
        plain.layout->hideAll();
        plain.layout->bringBack();
        QVERIFY(hidden);
    }
    void theProgramsLayoutIsNotSaved()
    {
        PlainWindow plain;
        plain.show();
        plain.layout->toggle("compare");
        plain.layout->raise("layers");
        plain.layout->hideAll();
        plain.layout->bringBack();
        plain.layout->save();
        QVERIFY(!QSettings().childGroups().contains("layouts"));
    }
    void onesOwnLayoutIsKeptAndSavedAsItWasBeforeThePanelsWereHidden()
    {
        PlainWindow plain;
        plain.show();
        plain.window.addDockWidget(Qt::LeftDockWidgetArea, &plain.dock("layers"));
        plain.window.resize(1280, 700);
        plain.layout->fitWindow();
        QCOMPARE(plain.inFront(), stack);
        plain.layout->hideAll();
        plain.layout->save();
        const QVariant saved = QSettings().value("layouts/workspace-cut");
        QVERIFY(saved.isValid());
        PlainWindow next; // has other settings
        QSettings().setValue("layouts/workspace-cut", saved);
        next.show();
        QCOMPARE(next.inFront(), stack); // neither Start nor a comparison panel
        QCOMPARE(next.window.dockWidgetArea(&next.dock("layers")), Qt::LeftDockWidgetArea);
        next.layout->reset();
        QCOMPARE(next.window.dockWidgetArea(&next.dock("layers")), Qt::RightDockWidgetArea);
    }
};

} // namespace window_panel_layout_test

TEST_CLASS(window_panel_layout_test::PanelLayoutTest, Widgets)
#include "tests/ui/window/panel_layout_test.moc"

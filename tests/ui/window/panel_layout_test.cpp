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
const QStringList stack{"algorithm", "window", "cut-edges", "layers"};

QToolButton& chevron(const Dock& dock) { return *dock.findChild<FoldButton*>(); }

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
    void aWindowThatIsTooLowHasTabsBelow()
    {
        PlainWindow plain;
        plain.show();
        QCOMPARE(plain.inFront(), stack);
        plain.beLow();
        QCOMPARE(plain.inFront(), QStringList({"algorithm", "window", "cut-edges"}));
        QVERIFY(plain.window.tabifiedDockWidgets(&plain.dock("window"))
                    .contains(&plain.dock("layers")));
        QTRY_VERIFY(plain.dock("window").titleBarWidget()->height() == 0); // the tab is the title
        plain.window.resize(1280, 900);
        plain.layout->fit();
        QCOMPARE(plain.inFront(), stack);
    }
    void panelsThatAreTooHighShareTheLowestPlace()
    {
        PlainWindow plain;
        plain.show();
        plain.layout->choose(findWorkspace("workspace-draw"));
        PlainWindow::panel(plain.dock("properties")).least = 830;
        plain.layout->fit();
        QVERIFY(plain.window.tabifiedDockWidgets(&plain.dock("properties"))
                    .contains(&plain.dock("layers")));
        QVERIFY(plain.inFront().contains("layers") && !plain.inFront().contains("properties"));
    }
    void everyWorkspaceShowsItsPanels()
    {
        for (const Workspace& workspace : workspaces()) {
            PlainWindow plain;
            plain.show();
            plain.layout->choose(workspace);
            QStringList front = plain.inFront();
            QStringList wanted = workspace.column;
            front.sort();
            wanted.sort();
            QCOMPARE(front, wanted);
            for (const Dock* dock : plain.docks.all())
                QCOMPARE(dock->isFolded(), workspace.folds.contains(dock->objectName()));
        }
    }
    void aFoldedPanelIsOnlyItsHeading()
    {
        PlainWindow plain;
        plain.show();
        QCoreApplication::processEvents();
        Dock& algorithm = plain.dock("algorithm");
        QCOMPARE(algorithm.height(), algorithm.titleBarWidget()->height());
        QTest::mouseClick(&chevron(algorithm), Qt::LeftButton);
        QVERIFY(!algorithm.isFolded());
        QTRY_VERIFY(algorithm.height() > 60);
        QTest::mouseClick(algorithm.titleBarWidget(), Qt::LeftButton, {}, {200, 14});
        QVERIFY(algorithm.isFolded());
        QTRY_COMPARE(algorithm.height(), algorithm.titleBarWidget()->height());
        plain.layout->raise("algorithm"); // somebody asks for it
        QVERIFY(!algorithm.isFolded());
    }
    void oneSectionStaysOpen()
    {
        PlainWindow plain;
        plain.show();
        for (const char* key : {"window", "layers"}) {
            QVERIFY(!plain.dock(key).isFolded());
            chevron(plain.dock(key)).click();
        }
        QVERIFY(plain.dock("window").isFolded() && !plain.dock("layers").isFolded());
        plain.layout->choose(findWorkspace("workspace-compare"));
        QVERIFY(chevron(plain.dock("compare")).isHidden()); // the workspace's subject
    }
    void anUnfoldedSectionMakesOthersFoldUntilItIsFoldedAgain()
    {
        PlainWindow plain;
        plain.show();
        const Dock &algorithm = plain.dock("algorithm"), &layers = plain.dock("layers");
        PlainWindow::panel(algorithm).least = 700;
        chevron(algorithm).click();
        QVERIFY(!algorithm.isFolded() && layers.isFolded());
        QVERIFY(plain.window.tabifiedDockWidgets(&plain.dock("algorithm")).empty());
        chevron(algorithm).click();
        QVERIFY(algorithm.isFolded() && !layers.isFolded());
        chevron(algorithm).click();
        plain.layout->choose(findWorkspace("workspace-draw"));
        plain.layout->choose(findWorkspace("workspace-cut"));
        QVERIFY(!algorithm.isFolded() && layers.isFolded()); // it is remembered
    }
    void keysFoldAndUnfoldAndKeepTheFocus()
    {
        PlainWindow plain;
        plain.show();
        Dock& edges = plain.dock("cut-edges");
        QToolButton& heading = chevron(edges);
        heading.setFocus();
        QCOMPARE(heading.accessibleName(), QString("Unfold cut-edges"));
        const std::pair<Qt::Key, bool> keys[]{{Qt::Key_Space, false}, {Qt::Key_Return, true},
                                              {Qt::Key_Left, true},   {Qt::Key_Right, false},
                                              {Qt::Key_Right, false}, {Qt::Key_Left, true}};
        for (const auto& [key, folded] : keys) {
            QTest::keyClick(&heading, key);
            QCOMPARE(edges.isFolded(), folded);
            QVERIFY(edges.hasFocusInHeading());
        }
        PlainWindow::panel(edges).least = 700; // others fold
        QTest::keyClick(&heading, Qt::Key_Right);
        QVERIFY(!edges.isFolded() && edges.hasFocusInHeading());
        QVERIFY(plain.window.tabifiedDockWidgets(&edges).empty());
    }
    void aFoldIsRememberedForItsWorkspace()
    {
        PlainWindow plain;
        plain.show();
        const Workspace& compare = findWorkspace("workspace-compare");
        const Dock& panel = plain.dock("window");
        plain.layout->choose(compare);
        QVERIFY(panel.isFolded());
        chevron(panel).click();
        QVERIFY(!panel.isFolded());
        QCOMPARE(QSettings().value("folds/workspace-compare").toStringList(),
                 QStringList("difference")); // at once
        plain.layout->choose(findWorkspace("workspace-cut"));
        QVERIFY(!panel.isFolded());
        plain.layout->choose(compare);
        QVERIFY(!panel.isFolded());
        plain.layout->reset();
        QVERIFY(panel.isFolded());
        QSettings().setValue("folds/workspace-compare", QStringList{"compare", "x", "window"});
        plain.layout->choose(findWorkspace("workspace-cut"));
        plain.layout->choose(compare);
        QVERIFY(panel.isFolded());
        QVERIFY(!plain.dock("compare").isFolded() && !plain.dock("difference").isFolded());
    }
    void aPanelThatIsAskedForUnfolds()
    {
        PlainWindow plain;
        plain.show();
        plain.layout->choose(findWorkspace("workspace-compare"));
        const Dock& difference = plain.dock("difference");
        QVERIFY(difference.isFolded());
        plain.layout->toggle("difference");
        QVERIFY(difference.isVisible() && !difference.isFolded());
        plain.layout->toggle("difference");
        QVERIFY(difference.isVisible() && difference.isFolded());
        plain.dock("difference").close();
        QCoreApplication::processEvents();
        plain.layout->raise("difference");
        QVERIFY(difference.isVisible() && !difference.isFolded());
    }
    void aFurtherPanelSharesTheLowestPlace()
    {
        PlainWindow plain;
        plain.show();
        plain.dock("history").toggleViewAction()->trigger();
        QVERIFY(plain.inFront().contains("history"));
        QVERIFY(plain.window.tabifiedDockWidgets(&plain.dock("history"))
                    .contains(&plain.dock("layers")));
        plain.layout->choose(findWorkspace("workspace-draw"));
        plain.dock("line").toggleViewAction()->trigger(); // above the folded history
        QVERIFY(plain.window.tabifiedDockWidgets(&plain.dock("line"))
                    .contains(&plain.dock("properties")));
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
        QCOMPARE(plain.inFront(), stack + QStringList{"difference"});
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
        plain.beLow();
        plain.layout->toggle("compare");
        plain.layout->toggle("difference");
        plain.layout->raise("layers");
        QCoreApplication::processEvents();
        const auto before = places(plain);
        QCOMPARE(before.keys(), QStringList({"algorithm", "cut-edges", "difference", "layers"}));
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
        plain.beLow();
        QCOMPARE(plain.inFront(), QStringList());
        plain.layout->bringBack();
        QCOMPARE(plain.inFront(), QStringList("start"));
    }
    void panelsAskedForWhileAllAreHiddenAreShownWhenTheyComeBack()
    {
        PlainWindow plain;
        plain.show();
        plain.beLow();
        const QStringList low{"algorithm", "window", "cut-edges"};
        QCOMPARE(plain.inFront(), low);
        plain.layout->hideAll();
        plain.layout->toggle("compare");
        plain.layout->raise("line");
        QCOMPARE(plain.inFront(), QStringList());
        QVERIFY(!plain.layout->shows("compare") && !plain.layout->shows("line"));
        plain.layout->bringBack();
        QCOMPARE(plain.inFront(), QStringList({"algorithm", "cut-edges", "line", "compare"}));
        plain.layout->toggle("compare"); // it is known to be open
        QCOMPARE(plain.inFront(), low);
        plain.layout->hideAll();
        plain.layout->bringBack();
        QCOMPARE(plain.inFront(), low); // asked for once
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
        plain.beLow();
        plain.layout->raise("layers");
        plain.layout->hideAll();
        plain.layout->raise("start");
        plain.layout->leaveStart();
        QCOMPARE(plain.inFront(), QStringList());
        plain.layout->bringBack();
        QCOMPARE(plain.inFront(), QStringList({"algorithm", "cut-edges", "layers"}));
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
        plain.beLow();
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

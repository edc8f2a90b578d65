// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/variants.h"
#include "app/session/comparing.h"
#include "app/session/export_source.h"
#include "ui/docks/compare_panel.h"
#include "ui/docks/compare_table.h"
#include "ui/window/workspace_panes.h"
#include "ui/window/workspaces.h"

#include <QMenu>

#include "tests/content_of.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace window_workspace_panes_test {

using namespace ui;

namespace {

struct Bench : TestWindow {
    void go(const char* workspace) const { window->choose(findWorkspace(workspace)); }
    using TestWindow::show;
    std::size_t panes() const { return window->canvas().panes().size(); }
    void show(const app::Variant& variant) const
    {
        window->session().changeDisplay(
            [&variant](app::Display& display) { display.variant = variant; });
    }
    /// A line that KWC loses as published, because it is almost vertical.
    void openSteepLine() const
    {
        open(file("steep.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' "
                               "height='100mm' viewBox='0 0 100 100'>"
                               "<path d='M50 -20 50.5 120' stroke='#123456'/></svg>"));
        run("window-on-page");
    }
    bool exportsTheLine() const
    {
        const QString file = path("cut.svg");
        window->files().exportTo({app::exportSourceOf(window->session()), {}}, file);
        window->files().wait();
        return contentOf(file).contains("#123456");
    }
};

} // namespace

class WorkspacePanesTest : public QObject {
    Q_OBJECT

    const app::Variant published_ = *app::findVariant("kwc:published");

private slots:
    void aWorkspaceHasPanesOfItsOwn()
    {
        Bench t;
        t.go("workspace-compare");
        t.run("panes-4");
        t.go("workspace-draw");
        QCOMPARE(t.panes(), std::size_t(1));
        t.go("workspace-compare");
        QCOMPARE(t.panes(), std::size_t(4));
        t.go("workspace-learn");
        t.run("panes-2");
        t.go("workspace-draw");
        QCOMPARE(t.panes(), std::size_t(1));
        t.window = windowWithMenus(); // it starts in Draw
        QCOMPARE(t.window->workspace().key, "workspace-draw");
        QCOMPARE(t.panes(), std::size_t(1));
        t.go("workspace-learn");
        QCOMPARE(t.panes(), std::size_t(2));
        t.go("workspace-compare");
        QCOMPARE(t.panes(), std::size_t(4));
    }
    void whatIsComparedDoesNotCut()
    {
        Bench t;
        t.openSteepLine();
        for (const char* panes : {"panes-1", "panes-4"}) {
            t.go("workspace-compare");
            t.run(panes);
            t.show(published_);
            QCOMPARE(t.window->session().variant(), published_);
            QVERIFY(t.exportsTheLine());
            QVERIFY2(t.window->message().contains("KWC as published is only compared"),
                     qPrintable(t.window->message()));
            t.go("workspace-cut");
            QCOMPARE(t.window->session().variant(), app::exactVariant());
            QVERIFY(t.exportsTheLine());
        }
        t.window = windowWithMenus(); // nor after the program has begun again
        QCOMPARE(t.window->session().cuts(), app::exactVariant());
    }
    void aPaneThatIsClickedDoesNotCut()
    {
        Bench t;
        t.show();
        t.go("workspace-cut");
        t.run("panes-4");
        const auto choices = t.window->canvas().panes().choices();
        const auto place = std::ranges::find(choices, published_) - choices.begin();
        t.window->canvas().activatePane(std::size_t(place));
        QCOMPARE(t.window->session().variant(), published_);
        QCOMPARE(t.window->session().cuts(), app::exactVariant());
        t.run("panes-1");
        QCOMPARE(t.window->session().variant(), app::exactVariant());
    }
    void theLastPaneThatIsKeptCuts()
    {
        Bench t;
        t.go("workspace-cut");
        t.run("panes-2");
        t.window->canvas().activatePane(0);
        t.run("close-pane"); // that of Exact
        QCOMPARE(t.window->session().cuts(), t.window->canvas().panes().chosen());
        QVERIFY(t.window->session().cuts() != app::exactVariant());
    }
    void whatTheMicroscopeShowsDoesNotCut()
    {
        Bench t;
        t.openSteepLine();
        t.show();
        t.run("microscope");
        t.window->drawnLine().choose(published_);
        QCOMPARE(t.window->session().variant(), published_);
        QCOMPARE(t.window->session().cuts(), app::exactVariant());
        t.window->session().microscope.close();
        QCOMPARE(t.window->session().variant(), app::exactVariant());
    }
    void theMenuOfARowLetsItCut()
    {
        Bench t;
        t.openSteepLine();
        t.window->resize(1440, 900);
        t.show();
        t.go("workspace-compare");
        t.show(published_);
        CompareTable& table = t.window->comparePanel().table();
        QTRY_VERIFY(table.currentIndex().isValid());
        QContextMenuEvent key(QContextMenuEvent::Keyboard, QPoint(), table.mapToGlobal(QPoint()));
        QCoreApplication::sendEvent(&table, &key);
        auto* menu = t.window->findChild<QMenu*>("algorithm-menu");
        QVERIFY(menu);
        menu->findChild<QAction*>("use-published")->trigger();
        QCOMPARE(t.window->session().cuts(), published_);
        menu->close();
        t.go("workspace-cut");
        QCOMPARE(t.window->session().variant(), published_);
        QVERIFY(!t.exportsTheLine());
    }
};

} // namespace window_workspace_panes_test

TEST_CLASS(window_workspace_panes_test::WorkspacePanesTest, Widgets)
#include "tests/ui/window/workspace_panes_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/start_panel.h"
#include "ui/editing/keeping.h"
#include "ui/look/look.h"
#include "ui/window/panels.h"
#include "ui/window/workspaces.h"

#include <QDockWidget>
#include <QMenuBar>
#include <QStatusBar>
#include <QTabBar>

#include <algorithm>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace window_workspaces_test {

using namespace ui;

class WorkspacesTest : public QObject {
    Q_OBJECT

    static QTabBar& tabs(const TestWindow& t)
    {
        return *qobject_cast<QTabBar*>(t.window->menuBar()->cornerWidget());
    }
    static void click(const TestWindow& t, int tab)
    {
        QTest::mouseClick(&tabs(t), Qt::LeftButton, {}, tabs(t).tabRect(tab).center());
        QCoreApplication::processEvents();
    }
    static void showInDraw(TestWindow& t, QSize size)
    {
        t.open(t.twoLines());
        t.window->resize(size);
        t.show();
        click(t, 0);
    }
    static QMap<QString, QRect> places(const TestWindow& t)
    {
        QMap<QString, QRect> places;
        for (const auto* dock : t.window->findChildren<QDockWidget*>())
            if (dock->isVisible() && dock->x() >= 0)
                places[dock->objectName()] = dock->geometry();
        return places;
    }

private slots:
    void everyPanelOfAWorkspaceExists()
    {
        TestWindow t;
        for (const Workspace& workspace : workspaces()) {
            for (const QString& key : workspace.column)
                QVERIFY2(t.window->findChild<QDockWidget*>(key), qPrintable(key));
            for (const QString& key : workspace.folds)
                QVERIFY2(workspace.column.contains(key), qPrintable(key));
        }
    }
    void aTabOrAKeyChangesOnlyTheColumn()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.window->resize(1440, 900);
        t.show();
        const app::Document before = t.window->session().now();
        const double zoom = t.window->canvas().view().zoom;
        for (int tab = 0; tab < tabs(t).count(); ++tab) {
            click(t, tab);
            QCOMPARE(&t.window->workspace(), &workspaces()[std::size_t(tab)]);
            QCOMPARE(tabs(t).currentIndex(), tab);
            QTest::keyClick(t.window.get(), Qt::Key_1, Qt::ControlModifier | Qt::AltModifier);
            QCOMPARE(&t.window->workspace(), &workspaces().front());
        }
        QCOMPARE(t.window->session().history.count(), 0);
        QVERIFY(t.window->session().now().objects() == before.objects());
        QCOMPARE(t.window->canvas().view().zoom, zoom);
    }
    void theViewStaysAtItsCorner_data()
    {
        QTest::addColumn<bool>("fitted");
        QTest::addColumn<bool>("panes"); // in Compare, where the zoom is that of the panes
        QTest::newRow("fitted") << true << false;
        QTest::newRow("panned") << false << false;
        QTest::newRow("fitted, four panes") << true << true;
        QTest::newRow("panned, four panes") << false << true;
    }
    void theViewStaysAtItsCorner()
    {
        QFETCH(bool, fitted);
        QFETCH(bool, panes);
        TestWindow t;
        showInDraw(t, {1440, 900});
        const Canvas& canvas = t.window->canvas();
        const auto settled = [&] { waitForFinalSize(canvas); };
        settled();
        t.window->canvas().fitPage();
        if (!fitted)
            t.window->canvas().zoomBy(1.5);
        const app::View before = canvas.view();
        const auto stays = [&] {
            const app::Point moved = before.toDrawing({0, 0}) - canvas.view().toDrawing({0, 0});
            return std::abs(canvas.view().zoom / before.zoom - 1) < 1e-9
                   && std::abs(moved.x) + std::abs(moved.y) < 1e-6;
        };
        for (const int tab : {1, 2, 3, 2, 0}) {
            click(t, tab);
            if (panes && tab == 2)
                t.run("panes-4");
            settled();
            QVERIFY2(stays() || (panes && tab == 2), qPrintable(QString::number(tab)));
        }
        QVERIFY(canvas.view() == before);
        t.window->resize(1300, 800); // a fitted view still is
        settled();
        QCOMPARE(stays(), false);
    }
    void aNewDrawingBeginsInDraw()
    {
        TestWindow t;
        t.show();
        click(t, 1);
        emit t.window->findChild<StartPanel*>()->drawWanted();
        QCOMPARE(&t.window->workspace(), &findWorkspace("workspace-draw"));
        QCOMPARE(t.window->canvas().tool(), "line");
        QTRY_VERIFY(t.drawingArea()->hasFocus());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_R);
        QCOMPARE(t.window->canvas().tool(), "rectangle");
    }
    void aFoldedSectionIsOneLine_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1440 x 900") << QSize(1440, 900);
        QTest::newRow("1280 x 800") << QSize(1280, 800);
        QTest::newRow("1280 x 800 with a title bar and a panel of the desktop") << QSize(1280, 720);
    }
    void aFoldedSectionIsOneLine()
    {
        QFETCH(QSize, size);
        TestWindow t;
        showInDraw(t, size);
        for (int tab = 0; tab < tabs(t).count(); ++tab) {
            click(t, tab);
            for (const QString& key : t.window->workspace().folds) {
                const auto* dock = t.window->findChild<Dock*>(key);
                QVERIFY2(dock->isFolded() && dock->isVisible(), qPrintable(key));
                QCOMPARE(dock->height(), space::dockTitleHeight);
                QCOMPARE(dock->visibleRegion().boundingRect().height(), dock->height());
            }
        }
    }
    void aFoldedSectionSaysItsResult()
    {
        TestWindow t;
        showInDraw(t, {1440, 900});
        const auto says = [&t](const char* key, const char* text) {
            const auto* heading = t.window->findChild<Dock*>(key)->titleBarWidget();
            return std::ranges::any_of(heading->findChildren<QLabel*>(), [text](auto* label) {
                return label->accessibleName() == QString::fromUtf8(text);
            });
        };
        click(t, 1);
        QVERIFY(says("cut-edges", "areas open, every piece kept"));
        t.window->session().changeDisplay([](app::Display& display) {
            display.cutting = {true, true, 2};
            display.unit = app::Unit::Mm;
        });
        QVERIFY(says("cut-edges", "areas closed, no piece below 2.00 mm, hidden objects too"));
        layWindowOnPage(t.window->session());
        QVERIFY(says("window", "Rectangle"));
        QVERIFY(says("algorithm", "Exact for a window: rectangle"));
        setKeep(t.window->session(), app::Keep::Outside);
        QVERIFY(says("window", "all but Rectangle"));
        click(t, 0);
        QVERIFY(says("history", "Keep outside"));
    }
    void noPanelIsCut_data() { aFoldedSectionIsOneLine_data(); }
    void noPanelIsCut()
    {
        QFETCH(QSize, size);
        TestWindow t;
        showInDraw(t, size);
        std::vector<QRect> shown;
        for (const Dock* dock : t.window->findChildren<Dock*>()) {
            if (dock->visibleRegion().isEmpty())
                continue;
            shown.push_back(dock->geometry());
            const QWidget& body = dock->body();
            const int least = dock->isFolded()
                                  ? 0
                                  : std::max(body.minimumSizeHint().height(), body.minimumHeight());
            QVERIFY2(dock->height() >= space::dockTitleHeight + least,
                     qPrintable(dock->objectName()));
        }
        std::ranges::sort(shown, {}, &QRect::y);
        for (std::size_t i = 1; i < shown.size(); ++i)
            QVERIFY(shown[i - 1].bottom() < shown[i].top());
        QVERIFY(shown.back().bottom() < t.window->statusBar()->y());
        if (size.height() >= 800) // there is room for all of them
            for (const char* key : {"layers", "history"})
                QVERIFY(!t.window->findChild<Dock*>(key)->visibleRegion().isEmpty());
    }
    void whatIsSelectedMovesNoPanel_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1440 x 900") << QSize(1440, 900);
        QTest::newRow("1280 x 800") << QSize(1280, 800);
        QTest::newRow("1280 x 720") << QSize(1280, 720);
    }
    void whatIsSelectedMovesNoPanel()
    {
        QFETCH(QSize, size);
        TestWindow t;
        t.open(t.twoLines());
        t.window->resize(size);
        t.show();
        for (int tab = 0; tab < tabs(t).count(); ++tab) {
            click(t, tab);
            const auto before = places(t);
            t.window->session().select({0});
            t.window->session().inspect(std::size_t(1));
            QTest::qWait(60); // the panel Line follows after 30 ms
            QCOMPARE(places(t), before);
            t.window->session().inspect(std::nullopt);
            t.window->session().select({});
            QTest::qWait(60);
            QCOMPARE(places(t), before);
        }
    }
};

} // namespace window_workspaces_test

TEST_CLASS(window_workspaces_test::WorkspacesTest, Widgets)
#include "tests/ui/window/workspaces_test.moc"

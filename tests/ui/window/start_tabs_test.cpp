// SPDX-License-Identifier: GPL-3.0-or-later
// The panels beside the start panel stay reachable once it has gone.
#include "app/session/window_steps.h"
#include "ui/docks/dock.h"
#include "ui/window/workspaces.h"

#include <QTabBar>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace window_start_tabs_test {

using namespace ui;

namespace {

/// The tab bar that shows the panels.
QTabBar* tabBar(const MainWindow& window)
{
    for (QTabBar* bar : window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
        if (bar->isVisible() && bar->count() > 1)
            return bar;
    return nullptr;
}

} // namespace

class StartTabsTest : public QObject {
    Q_OBJECT

private slots:
    void tabsAreClickedAfterTheFirstEdit()
    {
        TestWindow test;
        test.window->resize(1280, 640);
        test.window->choose(findWorkspace("workspace-learn"));
        test.window->showStart();
        test.show();
        QTest::qWait(100);
        app::moveWindow(test.window->session(), {5, 5}); // the first edit
        QTest::qWait(100);
        QTabBar* bar = tabBar(*test.window);
        QVERIFY(bar);
        for (int tab = 0; tab < bar->count(); ++tab) {
            const QPoint middle = bar->mapTo(test.window.get(), bar->tabRect(tab).center());
            QWidget* under = test.window->childAt(middle);
            QVERIFY2(under == bar, qPrintable(QString::number(tab)));
            const QString title = bar->tabText(tab);
            QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(tab).center());
            QTest::qWait(50);
            for (const Dock* dock : test.window->findChildren<Dock*>())
                if (dock->windowTitle() == title)
                    QVERIFY2(!dock->isBehind(), qPrintable(title));
        }
    }
};

} // namespace window_start_tabs_test

TEST_CLASS(window_start_tabs_test::StartTabsTest, Widgets)
#include "tests/ui/window/start_tabs_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Objects that are dragged onto the tab of another drawing.
#include <QDrag>
#include <QMimeData>
#include <QStatusBar>
#include <QTimer>

#include "tests/test_class.h"
#include "tests/ui/editor/test_desk.h"

namespace editor_carried_test {

using namespace ui;

namespace {

struct TwoTabs : TestDesk {
    TwoTabs()
    {
        open(file("one.svg"));
        open(file("two.svg", 9));
        desk->showTab(0);
        desk->current().canvas().setTool("select");
        desk->current().canvas().settle();
    }
    app::Session& session(int tab) const { return desk->at(tab).session(); }
    std::size_t objects(int tab) const { return session(tab).now().objects().size(); }
    /// Drags the first object to the tab.
    void drag(int tab, Qt::KeyboardModifiers with = {})
    {
        MainWindow& window = desk->current();
        QWidget* area = window.canvas().focusProxy();
        const app::Point on = window.canvas().view().toScreen({50, 50});
        const QPoint from(qRound(on.x), qRound(on.y));
        const QPoint to = area->mapFromGlobal(tabs().mapToGlobal(tabs().tabRect(tab).center()));
        QTest::mouseMove(area, from);
        QTest::mousePress(area, Qt::LeftButton, {}, from);
        for (const QPoint& at : {from + QPoint(0, -20), to + QPoint(0, 1), to}) {
            QMouseEvent move(QEvent::MouseMove, at, area->mapToGlobal(at), Qt::NoButton,
                             Qt::LeftButton, with);
            QCoreApplication::sendEvent(area, &move);
        }
        said = window.statusBar()->currentMessage();
        QTest::mouseRelease(area, Qt::LeftButton, with, to);
        QCoreApplication::processEvents();
        for (int i = 0; i < desk->count(); ++i)
            desk->at(i).files().wait();
        QCoreApplication::processEvents();
    }
    QString said;
};

} // namespace

class CarriedTest : public QObject {
    Q_OBJECT

private slots:
    void areCopiedToTheTab()
    {
        TwoTabs t;
        const app::Path path = t.session(0).now().objects()[0].path();
        t.drag(1);
        QCOMPARE(t.said, "Release: copy to two.svg. Shift: move");
        QCOMPARE(t.tabs().currentIndex(), 1);
        QCOMPARE(t.objects(0), std::size_t(1));
        QCOMPARE(t.objects(1), std::size_t(2));
        QVERIFY(t.session(1).now().objects()[1].path() == path);
        QCOMPARE(t.session(1).selection(), app::ObjectRanges({1}));
        QCOMPARE(t.session(0).history.count(), 0); // nor has it been moved
        t.session(1).history.undo();
        QCOMPARE(t.objects(1), std::size_t(1));
    }
    void areDraggedOutOfTheWindow()
    {
        TwoTabs t;
        MainWindow& window = t.desk->current();
        const app::Document before = t.session(0).now();
        QWidget* area = window.canvas().focusProxy();
        const app::Point on = window.canvas().view().toScreen({50, 50});
        const QPoint from(qRound(on.x), qRound(on.y));
        const QPoint out =
            area->mapFromGlobal(window.window()->frameGeometry().bottomRight()) + QPoint(30, 30);
        QStringList kinds;
        QTimer ends; // in the loop that the drag waits in
        connect(&ends, &QTimer::timeout, this, [&] {
            if (const auto* drag = window.findChild<QDrag*>()) {
                kinds = drag->mimeData()->formats();
                QDrag::cancel();
            }
        });
        ends.start(5);
        QTest::mousePress(area, Qt::LeftButton, {}, from);
        for (const QPoint& at : {from + QPoint(0, -20), out}) {
            QMouseEvent move(QEvent::MouseMove, at, area->mapToGlobal(at), Qt::NoButton,
                             Qt::LeftButton, {});
            QCoreApplication::sendEvent(area, &move);
        }
        QTRY_VERIFY(kinds.contains("image/svg+xml"));
        QVERIFY(kinds.contains("application/pdf"));
        QTest::mouseRelease(area, Qt::LeftButton, {}, from);
        QVERIFY(t.session(0).now() == before);
        QCOMPARE(t.session(0).history.count(), 0);
    }
    void areMovedWithShift()
    {
        TwoTabs t;
        t.drag(1, Qt::ShiftModifier);
        QVERIFY(t.said.startsWith("Release: move"));
        QCOMPARE(t.objects(0), std::size_t(0));
        QCOMPARE(t.objects(1), std::size_t(2));
        QCOMPARE(t.session(0).history.undoText(), "Move to two.svg");
        t.session(0).history.undo();
        QCOMPARE(t.objects(0), std::size_t(1));
    }
    void theirOwnTabTakesNothing()
    {
        TwoTabs t;
        t.drag(0);
        QCOMPARE(t.said, QString());
        QCOMPARE(t.objects(0), std::size_t(1));
        QCOMPARE(t.session(0).history.count(), 1); // the move
        QCOMPARE(t.objects(1), std::size_t(1));
    }
    void aLockedLayerTakesNothing()
    {
        TwoTabs t;
        app::Session& second = t.session(1);
        app::Containers tree = second.now().containers();
        const app::ContainerId layer = tree.childrenOf(0)[0];
        app::Container locked = tree[layer];
        locked.locked = true;
        app::Document document = second.now();
        document.apply({.containers = tree.with(locked)});
        second.load({document, {}});
        t.drag(1, Qt::ShiftModifier);
        QCOMPARE(t.objects(0), std::size_t(1));
        QCOMPARE(t.objects(1), std::size_t(1));
        QVERIFY(t.desk->at(1).message().contains("locked"));
    }
};

} // namespace editor_carried_test

TEST_CLASS(editor_carried_test::CarriedTest, Widgets)
#include "tests/ui/editor/carried_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_steps.h"
#include "ui/canvas/ruler.h"
#include "ui/docks/algorithm_list.h"
#include "ui/look/look.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QSignalSpy>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace menus_context_menus_test {

using namespace ui;

// The menus of the right button.
class ContextMenusTest : public QObject {
    Q_OBJECT

    static QMenu* menuAt(QWidget& widget, const QPoint& place)
    {
        QContextMenuEvent event(QContextMenuEvent::Mouse, place, widget.mapToGlobal(place));
        QApplication::sendEvent(&widget, &event);
        return qobject_cast<QMenu*>(QApplication::activePopupWidget());
    }
    static QStringList keysOf(QMenu* menu)
    {
        QStringList keys;
        for (const QAction* action : menu ? menu->actions() : QList<QAction*>())
            keys << action->objectName();
        return keys;
    }
    static void choose(QMenu* menu, const QString& key)
    {
        for (QAction* action : menu->actions())
            if (action->objectName() == key)
                QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
    }
    static void close(QMenu* menu)
    {
        if (menu)
            menu->close();
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void nodesHaveTheirCommands()
    {
        Hand hand({shape({wave()})});
        hand.doubleClick({20, 50});
        QMenu* menu = menuAt(hand.surface(), hand.at({80, 50})); // selects the node
        QCOMPARE(hand.selected(), std::size_t(1));
        const QStringList keys = keysOf(menu);
        QVERIFY(keys.contains("corner-nodes") && keys.contains("split-path"));
        QVERIFY(keys.contains("delete-nodes") && !keys.contains("open-path"));
        QVERIFY(!keys.contains("group"));
        choose(menu, "corner-nodes");
        QCOMPARE(hand.session.nodes.path()[0].nodes[1].type, app::NodeType::Corner);
    }
    void theMenuKeepsSeveralNodesAndTakesSegments()
    {
        Hand hand({shape({corner()}), shape({{{120, 70}, {{{150, 70}}}, false}})});
        hand.doubleClick({20, 20});
        Hand::key(Qt::Key_A, Qt::ControlModifier);
        close(menuAt(hand.surface(), hand.at({100, 20})));
        QCOMPARE(hand.selected(), std::size_t(3));
        Hand::key(Qt::Key_Escape);
        QMenu* menu = menuAt(hand.surface(), hand.at({60, 20})); // a segment: its ends
        QVERIFY(keysOf(menu).contains("curve-segments"));
        close(menu);
        QCOMPARE(hand.selected(), std::size_t(2));
        close(menuAt(hand.surface(), hand.at({135, 70}))); // another path
        QCOMPARE(hand.session.selection(), (app::ObjectRanges{1}));
        QCOMPARE(hand.session.history.count(), 0);
    }
    void aWindowHasItsCommands()
    {
        Hand hand({shape({corner()})});
        QMenu* menu = menuAt(hand.surface(), hand.at({175, 85})); // its outline
        const QStringList keys = keysOf(menu);
        QVERIFY(keys.contains("crop") && keys.contains("remove-window") && !keys.contains("group"));
        QCOMPARE(keys.first(), "window-adds");
        QVERIFY(!keys.contains("window-intersects")); // it is the first
        close(menu);
        app::addWindow(hand.session, {.shape = app::RectangleShape{{{2, 2}, {9, 9}}}});
        app::reorderWindow(hand.session, 1, 0);
        hand.session.chooseWindow(1);
        choose(menuAt(hand.surface(), hand.at({175, 85})), "window-replaces");
        const auto& list = hand.session.windows().list;
        QCOMPARE(list[1].operation, app::WindowOperation::Replace);
        menu = menuAt(hand.surface(), hand.at({175, 90})); // inside
        QVERIFY(!keysOf(menu).contains("remove-window"));
        close(menu);
        auto* rows = hand.t.window->findChild<QListView*>("clip-windows");
        menu = menuAt(*rows->viewport(), rows->visualRect(rows->model()->index(1, 0)).center());
        for (const QAction* action : menu->actions())
            QCOMPARE(action->isChecked(), action->objectName() == "window-replaces"
                                              || action->objectName() == "keep-inside");
        choose(menu, "remove-window");
        QCOMPARE(list.size(), std::size_t(1));
    }
    void theNameOfAWindowHasItsMenu()
    {
        Hand hand({shape({corner()})});
        app::addWindow(hand.session, {.shape = app::RectangleShape{{{20, 20}, {60, 60}}}});
        QCOMPARE(hand.session.windowNumber(), std::size_t(1));
        const QPoint below = hand.at({160, 95}) + QPoint(10, 14);
        close(menuAt(hand.surface(), below));
        QCOMPARE(hand.session.windowNumber(), std::size_t(0));
    }
    void aClickOnTheNameOfAWindowChoosesIt()
    {
        Hand hand({shape({corner()})});
        app::addWindow(hand.session, {.shape = app::RectangleShape{{{20, 20}, {60, 60}}}});
        const QPoint below = hand.at({160, 95}) + QPoint(10, 14);
        QMouseEvent there(QEvent::MouseMove, below, hand.surface().mapToGlobal(below), Qt::NoButton,
                          Qt::NoButton, Qt::NoModifier);
        QSignalSpy told(&hand.canvas, &Canvas::hint); // the status bar shows it
        QApplication::sendEvent(&hand.surface(), &there);
        QCOMPARE(told.size(), 1);
        QVERIFY(hand.canvas.toolHint().startsWith("Click: choose this clip window."));
        QCOMPARE(hand.surface().cursor().shape(), Qt::PointingHandCursor);
        QTest::mouseDClick(&hand.surface(), Qt::LeftButton, {}, below);
        QCOMPARE(hand.session.windowNumber(), std::size_t(0));
        QCOMPARE(hand.session.history.count(), 1);
        QVERIFY(!hand.canvas.toolHint().startsWith("Click: choose"));
    }
    void anEyeHidesAWindowAndLeavesTheChosenOne()
    {
        Hand hand({shape({corner()})});
        for (const double x : {20.0, 70.0})
            app::addWindow(hand.session, {.shape = app::RectangleShape{{{x, 20}, {x + 40, 60}}}});
        auto* rows = hand.t.window->findChild<QListView*>("clip-windows");
        rows->setFixedHeight(200); // without scrolling
        const QRect row = rows->visualRect(rows->model()->index(1, 0));
        QTest::mouseClick(rows->viewport(), Qt::LeftButton, {},
                          {row.left() + space::dockMargin + 8, row.center().y()});
        QVERIFY(!hand.session.windows().list[1].visible);
        QCOMPARE(hand.session.windowNumber(), std::size_t(2));
        QTRY_COMPARE(rows->currentIndex().row(), 2);
        QTest::mouseDClick(rows->viewport(), Qt::LeftButton, {},
                           {row.left() + space::dockMargin + 8, row.center().y()});
        QVERIFY(!rows->findChild<QLineEdit*>()); // two clicks, not a new name
    }
    void aWindowIsRenamedInItsRow()
    {
        Hand hand({shape({corner()})});
        choose(menuAt(hand.surface(), hand.at({175, 85})), "rename-window");
        auto* rows = hand.t.window->findChild<QListView*>("clip-windows");
        auto* field = rows->findChild<QLineEdit*>();
        QVERIFY(field && field->isVisible());
        QTest::keyClicks(field, "Market hall");
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(hand.session.windows().list[0].name, "Market hall");
    }
    void objectsHaveTheirStyle()
    {
        Hand hand({shape({corner()}), shape({{{120, 70}, {{{150, 70}}}, false}})});
        QMenu* menu = menuAt(hand.surface(), hand.at({60, 20}));
        QVERIFY(keysOf(menu).contains("style") && keysOf(menu).contains("copy-style"));
        choose(menu, "copy-style");
        menu = menuAt(hand.surface(), hand.at({135, 70}));
        QVERIFY(keysOf(menu).contains("paste-style"));
        close(menu);
    }
    void rulersShowAndRemoveGuides()
    {
        Hand hand({shape({corner()})});
        auto* ruler = hand.canvas.findChild<Ruler*>();
        QMenu* menu = menuAt(*ruler, ruler->rect().center());
        QVERIFY(keysOf(menu).contains("guides") && !keysOf(menu).contains("remove-guides"));
        choose(menu, "guides");
        QVERIFY(!hand.session.display().guides);
        hand.session.changeDisplay([](app::Display& display) { display.guides = true; });
        QTest::mousePress(ruler, Qt::LeftButton, {}, ruler->rect().center());
        QTest::mouseMove(ruler, ruler->rect().center() + QPoint(40, 200));
        QTest::mouseRelease(ruler, Qt::LeftButton, {}, ruler->rect().center() + QPoint(40, 200));
        QCOMPARE(hand.session.now().page().guides.list.size(), std::size_t(1));
        choose(menuAt(*ruler, ruler->rect().center()), "remove-guides");
        QVERIFY(hand.session.now().page().guides.list.empty());
    }
    void algorithmsAreUsedComparedAndNamed()
    {
        Hand hand({shape({corner()})});
        hand.t.window->raisePanel("algorithm");
        auto* list = hand.t.window->findChild<AlgorithmList*>();
        const int row = [] {
            for (int i = 0; i < int(clipping::algorithms().size()); ++i)
                if (clipping::algorithms()[std::size_t(i)].key == "liang-barsky")
                    return i;
            return -1;
        }();
        const auto& algorithm = clipping::algorithms()[std::size_t(row)];
        const auto open = [&] {
            return menuAt(*list->viewport(),
                          list->visualRect(list->model()->index(row, 0)).center());
        };
        QVERIFY(keysOf(open()).contains("use-corrected"));
        choose(qobject_cast<QMenu*>(QApplication::activePopupWidget()), "use-published");
        QCOMPARE(hand.session.variant(), (app::Variant{&algorithm, clipping::Form::Published}));
        QMenu* menu = open();
        QVERIFY(keysOf(menu).contains("use-corrected") && !keysOf(menu).contains("use-published"));
        QVERIFY(!keysOf(menu).contains("show-in-pane")); // the pane shows it
        choose(menu, "copy-name");
        QCOMPARE(QGuiApplication::clipboard()->text(), QString(algorithm.name.data()));
        choose(open(), "compare-as-b");
        QTRY_VERIFY(hand.session.differences.asked());
        QCOMPARE(hand.session.differences.asked()->b.algorithm, &algorithm);
    }
    void anAlgorithmIsShownInAnotherPane()
    {
        Hand hand({shape({corner()})});
        hand.t.window->raisePanel("algorithm");
        auto* list = hand.t.window->findChild<AlgorithmList*>();
        choose(menuAt(*list->viewport(), list->visualRect(list->model()->index(2, 0)).center()),
               "show-in-pane");
        const app::Panes& panes = hand.canvas.panes();
        QCOMPARE(panes.size(), std::size_t(2));
        QCOMPARE(panes.active(), std::size_t(0));
        QCOMPARE(panes.choices()[1].algorithm, &clipping::algorithms()[2]);
    }
};

} // namespace menus_context_menus_test

TEST_CLASS(menus_context_menus_test::ContextMenusTest, Widgets)
#include "tests/ui/menus/context_menus_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_containers.h"

#include <QElapsedTimer>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_nodes_test {

// The tool Nodes, with mouse and keys only.
class NodesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void theKeyNTakesTheToolAndAClickShowsNodes()
    {
        Hand hand({shape({corner()})});
        Hand::key(Qt::Key_N);
        QCOMPARE(hand.canvas.tool(), std::string_view("nodes"));
        hand.click({60, 20});
        QCOMPARE(hand.session.selection().size(), std::size_t(1));
        QCOMPARE(hand.session.nodes.summary().nodes, std::size_t(3));
        hand.click({100, 20});
        QCOMPARE(hand.selected(), std::size_t(1));
        hand.click({100, 80}, Qt::ShiftModifier);
        QCOMPARE(hand.selected(), std::size_t(2));
        hand.click({100, 80}, Qt::ShiftModifier);
        QCOMPARE(hand.selected(), std::size_t(1));
        hand.drag({10, 10}, {110, 30}); // a box
        QCOMPARE(hand.selected(), std::size_t(2));
        hand.click({60, 20}); // a segment: its ends
        QCOMPARE(hand.selected(), std::size_t(2));
        QCOMPARE(hand.session.history.count(), 0);
    }
    void aNodeIsDraggedAndTheOthersStay()
    {
        Hand hand({shape({corner()})});
        hand.doubleClick({60, 20});
        QCOMPARE(hand.canvas.tool(), std::string_view("nodes"));
        hand.drag({100, 20}, {130, 40});
        QVERIFY(hand.isNear(hand.path().segments[0].to, {130, 40}));
        QCOMPARE(hand.path().start, corner().start);
        QCOMPARE(hand.path().segments[1], corner().segments[1]);
        QCOMPARE(hand.session.history.count(), 1);
        hand.drag({130, 40}, {60, 90}); // it is still selected
        QCOMPARE(hand.session.history.count(), 2);
        Hand::key(Qt::Key_Z, Qt::ControlModifier);
        Hand::key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(hand.path() == corner());
    }
    void nodesOnOneSpotAreTold()
    {
        const app::Subpath folded{{20, 20}, {{{100, 20}}, {{60, 80}}, {{100, 20}}}, false};
        Hand hand({shape({folded})});
        Hand::key(Qt::Key_N);
        hand.click({60, 20});
        hand.click({60, 80});
        QVERIFY(hand.canvas.toolHint().startsWith("1 of 4 nodes"));
        hand.click({100, 20});
        QCOMPARE(hand.selected(), std::size_t(1));
        const QString hint = hand.canvas.toolHint();
        QVERIFY2(hint.startsWith("2 nodes on one spot, at x 100.00, y 20.00."), qPrintable(hint));
        hand.drag({95, 15}, {105, 25}); // the box that the hint names
        QCOMPARE(hand.selected(), std::size_t(2));
    }
    void anotherNodesEndAttractsIt()
    {
        Hand hand({shape({corner()}), shape({{{150, 30}, {{{180, 30}}}, false}})});
        hand.canvas.setSnapping(app::SnapTo::All);
        hand.doubleClick({60, 20});
        hand.drag({100, 20}, {150.3, 30.3});
        QCOMPARE(hand.path().segments[0].to, app::Point(150, 30)); // exactly
    }
    void aNodeSnapsToWhatStaysOfItsPath()
    {
        const app::Subpath hook{
            {20, 20}, {{{100, 20}}, {{100, 80}}, {{60, 80}}, {{60, 50}}}, false};
        Hand hand({shape({hook})});
        hand.canvas.setSnapping(app::SnapTo::Nothing.with("ends").with("middles").with("on-path"));
        hand.doubleClick({40, 20});
        const double pixel = 1 / hand.canvas.view().zoom;
        const app::Point little(100 + 5 * pixel, 20 + 5 * pixel);
        hand.drag({100, 20}, little); // not back to its old place
        QVERIFY(hand.isNear(hand.path().segments[0].to, little));
        const app::Point inward(100 - 40 * pixel, 20 + 4 * pixel); // near its old segment
        hand.drag(hand.path().segments[0].to, inward);
        QVERIFY(hand.isNear(hand.path().segments[0].to, inward));
        hand.drag(hand.path().segments[0].to, {60 + 4 * pixel, 80 - 4 * pixel});
        QCOMPARE(hand.path().segments[0].to, app::Point(60, 80)); // a node that stays
        hand.drag({60, 80}, {20 - 5 * pixel, 20 + 4 * pixel});
        QCOMPARE(hand.session.history.count(), 4);
    }
    void aHandleSnapsToNodesOfItsPath()
    {
        Hand hand({shape({wave()})});
        hand.canvas.setSnapping(app::SnapTo::Nothing.with("ends"));
        hand.doubleClick({20, 50});
        hand.click({80, 50});
        const double pixel = 1 / hand.canvas.view().zoom;
        hand.drag({100, 80}, {140 + 4 * pixel, 50 + 4 * pixel});
        QCOMPARE(hand.path().segments[1].control1, app::Point(140, 50));
    }
    void draggedSegmentsTakeADistance()
    {
        Hand hand({shape({corner()})});
        const app::Variant before = hand.session.variant();
        hand.doubleClick({60, 20});
        hand.press({70, 20});
        hand.move({75, 30}, Qt::LeftButton);
        Hand::type("12<-90\n"); // down
        hand.release({75, 30});
        QVERIFY(glm::distance(hand.path().start, app::Point(20, 32)) < 1e-9);
        QVERIFY(glm::distance(hand.path().segments[0].to, app::Point(100, 32)) < 1e-9);
        QCOMPARE(hand.path().segments[1].to, app::Point(100, 80));
        Hand curved({shape({wave()})});
        curved.doubleClick({20, 50});
        const app::Point on = app::Bezier{{20, 50}, {40, 10}, {60, 20}, {80, 50}}.at(0.5);
        curved.press(on);
        curved.move(on + app::Point(0, 9), Qt::LeftButton);
        Hand::type("6<90\n"); // up
        curved.release(on + app::Point(0, 9));
        const auto bent = curved.path();
        const app::Point now = app::Bezier{bent.start, bent.segments[0].control1,
                                           bent.segments[0].control2, bent.segments[0].to}
                                   .at(0.5);
        QVERIFY(glm::distance(now, on - app::Point(0, 6)) < 0.5);
        QCOMPARE(hand.session.variant(), before);
    }
    void shiftKeepsADraggedNodeOnItsAxis()
    {
        Hand hand({shape({corner()})});
        hand.doubleClick({60, 20});
        hand.click({100, 20});
        hand.press({100, 20});
        hand.move({120, 22}, Qt::LeftButton, Qt::ShiftModifier);
        hand.release({150, 23}, Qt::ShiftModifier);
        QVERIFY(std::abs(hand.path().segments[0].to.y - 20) < 1e-9);
    }
    void handlesFollowTheTypeOfTheirNode()
    {
        Hand hand({shape({wave()})});
        hand.doubleClick({20, 50});
        hand.click({80, 50});
        QCOMPARE(hand.session.nodes.path()[0].nodes[1].type, app::NodeType::Symmetric);
        Hand::key(Qt::Key_C, Qt::ShiftModifier);
        hand.drag({100, 80}, {110, 70});
        const auto corner = hand.path();
        QVERIFY(hand.isNear(corner.segments[1].control1, {110, 70}));
        QCOMPARE(corner.segments[0].control2, app::Point(60, 20)); // a corner: the other one stays
        Hand::key(Qt::Key_S, Qt::ShiftModifier);
        hand.drag(hand.path().segments[1].control1, {80, 90});
        QVERIFY(hand.isNear(hand.path().segments[1].control1, {80, 90}));
        QVERIFY(std::abs(hand.path().segments[0].control2.x - 80) < 1); // in line
        Hand::key(Qt::Key_Y, Qt::ShiftModifier);
        const auto& [first, second] = std::pair(hand.path().segments[0], hand.path().segments[1]);
        QVERIFY(glm::distance(first.control2 + second.control1, app::Point(160, 100)) < 1e-9);
    }
    void doubleClickOnThePathAddsANodeAndKeepsTheShape()
    {
        Hand hand({shape({wave()})});
        hand.doubleClick({80, 50}); // on the path, at a node
        QCOMPARE(hand.path().segments.size(), std::size_t(2));
        const app::Point on = app::Bezier{{20, 50}, {40, 10}, {60, 20}, {80, 50}}.at(0.4);
        hand.doubleClick(on);
        QCOMPARE(hand.path().segments.size(), std::size_t(3));
        QVERIFY(hand.isNear(hand.path().segments[0].to, on));
        QCOMPARE(hand.selected(), std::size_t(1));
        Hand::key(Qt::Key_Delete); // and its deletion gives the curve back
        QCOMPARE(hand.path().segments.size(), std::size_t(2));
        QVERIFY(glm::distance(hand.path().segments[0].control1, app::Point(40, 10)) < 1e-6);
        QVERIFY(glm::distance(hand.path().segments[0].control2, app::Point(60, 20)) < 1e-6);
    }
    void deleteWithoutNodesRemovesTheObject()
    {
        Hand hand({shape({corner()}), shape({wave()})});
        hand.doubleClick({60, 20});
        Hand::key(Qt::Key_Delete);
        QCOMPARE(hand.session.now().objects().size(), std::size_t(1));
    }
    void keysMakeLinesCurvesAndBack()
    {
        Hand hand({shape({corner()})});
        hand.doubleClick({60, 20});
        hand.click({60, 20});
        Hand::key(Qt::Key_U, Qt::ShiftModifier);
        QVERIFY(hand.path().segments[0].curved && !hand.path().segments[1].curved);
        Hand::key(Qt::Key_L, Qt::ShiftModifier);
        QVERIFY(hand.path() == corner());
        Hand::key(Qt::Key_Insert);
        QCOMPARE(hand.path().segments.size(), std::size_t(3));
        QCOMPARE(hand.path().segments[0].to, app::Point(60, 20));
    }
    void aCurveIsBentByItsSegment()
    {
        Hand hand({shape({wave()})});
        hand.doubleClick({20, 50});
        const app::Point on = app::Bezier{{20, 50}, {40, 10}, {60, 20}, {80, 50}}.at(0.5);
        hand.drag(on, on + app::Point(0, -15));
        const auto path = hand.path();
        QVERIFY(path.start == wave().start && path.segments[0].to == wave().segments[0].to);
        const app::Bezier bent{path.start, path.segments[0].control1, path.segments[0].control2,
                               path.segments[0].to};
        QVERIFY(glm::distance(bent.at(0.5), on + app::Point(0, -15)) < 2 / hand.canvas.view().zoom);
    }
    void splitsJoinsReversesAndCloses()
    {
        Hand hand({shape({corner()})});
        hand.doubleClick({60, 20});
        hand.click({100, 20});
        Hand::key(Qt::Key_B, Qt::ShiftModifier);
        QCOMPARE(hand.paths().size(), std::size_t(2));
        hand.drag({100, 20}, {120, 30}); // the second part comes away
        QCOMPARE(hand.paths()[0].segments[0].to, app::Point(100, 20));
        QVERIFY(hand.isNear(hand.paths()[1].start, {120, 30}));
        hand.click({100, 20}, Qt::ShiftModifier);
        QCOMPARE(hand.selected(), std::size_t(2));
        Hand::key(Qt::Key_J, Qt::ShiftModifier);
        QCOMPARE(hand.paths().size(), std::size_t(1));
        QCOMPARE(hand.path().segments.size(), std::size_t(3));
        Hand::key(Qt::Key_R, Qt::ShiftModifier);
        QCOMPARE(hand.path().start, app::Point(100, 80));
        hand.t.action("close-path")->trigger();
        QVERIFY(hand.path().closed);
        hand.t.action("open-path")->trigger();
        QVERIFY(!hand.path().closed);
    }
    void looseLinesAreJoinedFromTheSelectToolToo()
    {
        Hand hand({shape({{{20, 20}, {{{80, 20}}}, false}}),
                   shape({{{80, 20}, {{{80, 80}}}, false}}),
                   shape({{{80, 80}, {{{20, 20}}}, false}})});
        Hand::key(Qt::Key_A, Qt::ControlModifier);
        Hand::key(Qt::Key_J, Qt::ShiftModifier);
        QTest::keyClick(QApplication::activeModalWidget(), Qt::Key_Return); // the usual distance
        QCOMPARE(hand.session.now().objects().size(), std::size_t(1));
        QVERIFY(hand.path().closed && hand.path().segments.size() == 2);
    }
    void typedCoordinatesMoveTheNode()
    {
        Hand hand({shape({corner()})});
        hand.doubleClick({60, 20});
        hand.click({100, 20});
        hand.move({30, 70}, Qt::NoButton);
        Hand::type("110,33\n");
        QCOMPARE(hand.path().segments[0].to, app::Point(110, 33));
        Hand::type("@10,-3\n");
        QCOMPARE(hand.path().segments[0].to, app::Point(120, 30));
        Hand::type("#7,8\n");
        QCOMPARE(hand.path().segments[0].to, app::Point(7, 8));
        Hand::type("5<90\n");
        QVERIFY(glm::distance(hand.path().segments[0].to, app::Point(7, 3)) < 1e-9);
        Hand::type("50\n"); // x alone
        QCOMPARE(hand.path().segments[0].to.x, 50.0);
        QVERIFY(std::abs(hand.path().segments[0].to.y - 3) < 1e-9);
        QCOMPARE(hand.session.history.count(), 5);
    }
    void typedCoordinatesHoldWhileItIsDragged()
    {
        Hand hand({shape({corner()})});
        hand.doubleClick({60, 20});
        hand.press({100, 20});
        hand.move({120, 30}, Qt::LeftButton);
        Hand::type("111,22\n");
        QCOMPARE(hand.path().segments[0].to, app::Point(111, 22));
        hand.move({150, 60}, Qt::LeftButton);
        hand.release({150, 60});
        QCOMPARE(hand.path().segments[0].to, app::Point(111, 22)); // the drag was over
        QCOMPARE(hand.session.history.count(), 1);
    }
    void nonsenseIsRefusedAndMovesNothing()
    {
        Hand hand({shape({corner()})});
        hand.doubleClick({60, 20});
        hand.click({100, 20});
        Hand::type("1e999\n");
        QVERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
        Hand::key(Qt::Key_Escape);
        QVERIFY(hand.path() == corner());
        QCOMPARE(hand.selected(), std::size_t(1));
    }
    void withoutTheMouse()
    {
        Hand hand({shape({corner()})});
        Hand::key(Qt::Key_A, Qt::ControlModifier);
        Hand::key(Qt::Key_N);
        Hand::key(Qt::Key_Tab);
        Hand::key(Qt::Key_Tab);
        Hand::key(Qt::Key_Right);
        Hand::key(Qt::Key_Right);
        Hand::key(Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(hand.path().segments[0].to, app::Point(102, 30)); // 1 unit is 1 mm
        Hand::key(Qt::Key_Backtab, Qt::ShiftModifier);
        Hand::type("5,6\n");
        QCOMPARE(hand.path().start, app::Point(5, 6));
        Hand::key(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(hand.selected(), std::size_t(3));
        Hand::key(Qt::Key_Escape);
        QCOMPARE(hand.selected(), std::size_t(0));
        QCOMPARE(hand.canvas.tool(), std::string_view("nodes"));
        Hand::key(Qt::Key_Escape);
        QCOMPARE(hand.canvas.tool(), std::string_view("select"));
        QCOMPARE(hand.session.selection().size(), std::size_t(1));
    }
    void escapeCancelsADrag()
    {
        Hand hand({shape({corner()})});
        hand.doubleClick({60, 20});
        hand.press({100, 20});
        hand.move({150, 60}, Qt::LeftButton);
        Hand::key(Qt::Key_Escape);
        hand.release({150, 60});
        QVERIFY(hand.path() == corner());
        QCOMPARE(hand.session.history.count(), 0);
    }
    void aRectangleBecomesAPlainPath()
    {
        Hand hand({});
        Hand::key(Qt::Key_R);
        hand.drag({20, 20}, {100, 70});
        QVERIFY(hand.session.now().objects()[0].particulars().recipe.index() != 0);
        Hand::key(Qt::Key_V);
        hand.doubleClick({60, 20});
        QCOMPARE(hand.session.nodes.summary().nodes, std::size_t(4));
        hand.drag({100, 20}, {120, 10});
        QCOMPARE(hand.session.now().objects()[0].particulars().recipe.index(), std::size_t(0));
        QVERIFY(hand.path().closed);
        Hand::key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(hand.session.now().objects()[0].particulars().recipe.index() != 0);
    }
    void whatHappensToTheDrawingDuringADragEndsIt()
    {
        Hand hand({shape({corner()}), shape({wave()})});
        hand.doubleClick({60, 20});
        hand.press({100, 20});
        hand.move({150, 60}, Qt::LeftButton);
        Hand::key(Qt::Key_Delete);
        hand.move({150, 70}, Qt::LeftButton);
        hand.release({150, 70});
        hand.canvas.undo();
        QVERIFY(!hand.paths().empty());
        hand.press({100, 20});
        hand.move({150, 60}, Qt::LeftButton);
        hand.session.history.setIndex(0);
        hand.session.select({});
        hand.move({150, 70}, Qt::LeftButton);
        hand.release({150, 70});
        QVERIFY(hand.path() == corner());
    }
    void aLockedLayerIsRefusedWithOneSentence()
    {
        Hand hand({shape({corner()})});
        hand.doubleClick({60, 20});
        hand.click({100, 20});
        app::Containers tree = hand.session.now().containers();
        app::Container layer = tree[tree.childrenOf(0)[0]];
        layer.locked = true;
        hand.session.history.push(
            new app::SetContainers(hand.session.document, tree.with(layer), "Lock"));
        hand.click({60, 20});
        QVERIFY(hand.session.selection().empty()); // it cannot be picked
        hand.session.select(app::ObjectRanges{0});
        QSignalSpy refused(&hand.session, &app::Session::refused);
        hand.drag({100, 20}, {130, 40});
        QCOMPARE(refused.size(), 1);
        QVERIFY(hand.t.window->message().contains("locked"));
        QVERIFY(hand.path() == corner());
    }
    void twoNodesOnOneSpotComeApart()
    {
        Hand hand({shape({{{20, 20}, {{{100, 20}}, {{100, 20}}, {{100, 80}}}, false}})});
        hand.doubleClick({60, 20});
        hand.drag({100, 20}, {120, 40});
        QCOMPARE(hand.path().segments[0].to, app::Point(100, 20));
        QVERIFY(hand.isNear(hand.path().segments[1].to, {120, 40}));
    }
    void handlesWithoutLengthAreNoTrap()
    {
        Hand hand({shape({{{20, 50}, {{{80, 50}, {20, 50}, {80, 50}, true}}, false}})});
        hand.doubleClick({50, 50});
        hand.drag({80, 50}, {90, 60}); // the node, not its handle
        QVERIFY(hand.isNear(hand.path().segments[0].to, {90, 60}));
        QVERIFY(hand.isNear(hand.path().segments[0].control2, {90, 60}));
        Hand::key(Qt::Key_S, Qt::ShiftModifier); // an end has no type, and says so
        QVERIFY(hand.t.action("smooth-nodes")->toolTip().endsWith('.'));
    }
    void aMillionNodesAreShownAndMoved()
    {
        app::Subpath path{{0, 0}, {}, false};
        for (int i = 1; i < 1'000'000; ++i)
            path.segments.push_back({app::Point(i * 2e-4, 50 + 30 * std::sin(i * 1e-4))});
        Hand hand({shape({path})});
        Hand::key(Qt::Key_A, Qt::ControlModifier);
        Hand::key(Qt::Key_N);
        QCOMPARE(hand.session.nodes.summary().nodes, std::size_t(1'000'000));
        QElapsedTimer timer;
        const auto took = [&] { return int(timer.restart()); };
        timer.start();
        hand.move({100, 40}, Qt::NoButton);
        const int hovering = took();
        hand.press(path.segments[499'999].to);
        hand.move({100, 80}, Qt::LeftButton);
        took();
        hand.move({100, 90}, Qt::LeftButton);
        const int moving = took();
        hand.release({100, 90});
        const int releasing = took();
        QCOMPARE(hand.session.history.count(), 1);
        hand.canvas.settle();
        took();
        hand.surface().grab();
        const int painting = took();
        qInfo("hover %d ms, drag %d ms, release %d ms, paint %d ms", hovering, moving, releasing,
              painting);
        QVERIFY(hovering < 1000 && moving < 2000 && releasing < 10'000 && painting < 5000);
    }
    void theMenuSaysWhyACommandIsDisabled()
    {
        Hand hand({shape({corner()})});
        QAction* join = hand.t.action("join-ends");
        QAction* smooth = hand.t.action("smooth-nodes");
        QVERIFY(!join->isEnabled() && join->toolTip().contains("selected"));
        Hand::key(Qt::Key_A, Qt::ControlModifier);
        QVERIFY(join->isEnabled());
        QVERIFY(!smooth->isEnabled() && smooth->toolTip().contains("Nodes (N)"));
        Hand::key(Qt::Key_N);
        QVERIFY(smooth->toolTip().contains("Tab"));
        hand.click({100, 20});
        QVERIFY(smooth->isEnabled() && !smooth->isChecked());
        QVERIFY(hand.t.action("corner-nodes")->isChecked());
        smooth->trigger();
        QVERIFY(smooth->isChecked() && !hand.t.action("corner-nodes")->isChecked());
        hand.t.action("close-path")->trigger();
        QVERIFY(!join->isEnabled() && join->toolTip().contains("closed"));
        QVERIFY(!hand.t.action("close-path")->isEnabled());
    }
    void aDoubleClickEditsATextAlsoWhileItsNodesAreShown()
    {
        Hand hand({});
        Hand::key(Qt::Key_T);
        hand.click({40, 60});
        Hand::type("Hm");
        Hand::key(Qt::Key_Escape);
        QCOMPARE(hand.session.now().objects().size(), std::size_t(1));
        const app::Point stem = hand.path().start;
        Hand::key(Qt::Key_N);
        hand.click(stem); // shows its nodes
        QVERIFY(hand.session.nodes.summary().nodes > 0);
        const app::Point end = hand.path().segments[0].to;
        hand.doubleClick(stem * 0.6 + end * 0.4);
        QCOMPARE(hand.canvas.tool(), std::string_view("text"));
        Hand::type("a");
        Hand::key(Qt::Key_Escape);
        const auto& recipe = hand.session.now().objects()[0].particulars().recipe;
        QVERIFY(std::holds_alternative<app::TextRecipe>(recipe));
    }
    void aDoubleClickEntersAGroup()
    {
        Hand hand({shape({corner()}), shape({wave()})});
        Hand::key(Qt::Key_A, Qt::ControlModifier);
        Hand::key(Qt::Key_G, Qt::ControlModifier);
        Hand::key(Qt::Key_Escape);
        Hand::key(Qt::Key_N);
        hand.session.select({});
        hand.doubleClick({60, 20});
        QVERIFY(hand.session.entered.id() != 0);
        QCOMPARE(hand.canvas.tool(), std::string_view("nodes"));
        QCOMPARE(hand.session.selection(), (app::ObjectRanges{0}));
        QCOMPARE(hand.session.nodes.summary().nodes, std::size_t(3));
        hand.doubleClick({60, 20}); // now its nodes are shown
        QCOMPARE(hand.session.nodes.summary().nodes, std::size_t(4));
    }
    void aDoubleClickOnAnotherPathOnlyShowsItsNodes()
    {
        Hand hand({shape({corner()}), shape({{{120, 70}, {{{150, 70}}}, false}})});
        hand.doubleClick({60, 20});
        hand.doubleClick({135, 70});
        QCOMPARE(hand.session.selection(), (app::ObjectRanges{1}));
        QCOMPARE(hand.session.nodes.summary().nodes, std::size_t(2));
        QCOMPARE(hand.session.history.count(), 0);
    }
};

} // namespace tools_nodes_test

TEST_CLASS(tools_nodes_test::NodesTest, Widgets)
#include "tests/ui/tools/nodes_test.moc"

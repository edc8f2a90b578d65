// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>

#include <numbers>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_end_drag_test {

// The round ends of a line that was clicked with the tool Select.
class EndDragTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void theEndHandleOfALineMovesThatEnd()
    {
        Hand hand({shape({{{20, 20}, {{{100, 20}}}, false}})});
        hand.click({60, 20});
        hand.drag({100, 20}, {110, 60});
        QCOMPARE(hand.path().start, app::Point(20, 20));
        QVERIFY(hand.isNear(hand.path().segments[0].to, {110, 60}));
        QCOMPARE(hand.session.history.count(), 1);
        QVERIFY(hand.session.inspected().has_value()); // so it can be dragged on
        hand.drag(hand.path().segments[0].to, {120, 30});
        QVERIFY(hand.isNear(hand.path().segments[0].to, {120, 30}));
        hand.drag({20, 20}, {30, 30});
        QVERIFY(hand.isNear(hand.path().start, {30, 30}));
    }
    void theEndHandleTakesALength()
    {
        Hand hand({shape({{{20, 20}, {{{100, 20}}}, false}})});
        hand.click({60, 20});
        hand.press({100, 20});
        hand.move({100, 60}, Qt::LeftButton);
        Hand::type("50<0\n");
        hand.release({100, 60});
        QCOMPARE(hand.path().segments[0].to, app::Point(70, 20));
    }
    void escapeLeavesTheLineAsItWas()
    {
        Hand hand({shape({{{20, 20}, {{{100, 20}}}, false}})});
        hand.click({60, 20});
        hand.press({100, 20});
        hand.move({100, 60}, Qt::LeftButton);
        Hand::key(Qt::Key_Escape);
        hand.release({100, 60});
        QCOMPARE(hand.path().segments[0].to, app::Point(100, 20));
        QVERIFY(!hand.session.preview().line);
    }
    void theMiddleOfTheLineStillMovesIt()
    {
        Hand hand({shape({{{20, 20}, {{{100, 20}}}, false}})});
        hand.click({60, 20});
        hand.drag({60, 20}, {70, 40});
        QVERIFY(hand.isNear(hand.path().start, {30, 40}));
        QVERIFY(glm::distance(hand.path().segments[0].to - hand.path().start, app::Point(80, 0))
                < 1e-9);
    }
    void aLineThatIsSelectedInAnyWayHasItsHandles()
    {
        const app::Subpath line{{20, 20}, {{{100, 20}}}, false};
        const auto isDragged = [](Hand& hand, const app::Point& end, std::size_t object) {
            QCoreApplication::processEvents();
            hand.drag(end, {110, 60});
            return hand.isNear(hand.paths(object).front().segments[0].to, {110, 60})
                   && hand.session.inspected().has_value();
        };
        Hand all({shape({line})});
        Hand::key(Qt::Key_A, Qt::ControlModifier);
        QVERIFY(isDragged(all, {100, 20}, 0));
        Hand undone({shape({line})});
        undone.click({60, 20});
        Hand::key(Qt::Key_Right);
        Hand::key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(isDragged(undone, {100, 20}, 0));
        Hand copied({shape({line})});
        copied.click({60, 20});
        Hand::key(Qt::Key_D, Qt::ControlModifier);
        QVERIFY(isDragged(copied, {100, 20}, 1));
        Hand pasted({shape({line})});
        pasted.click({60, 20});
        Hand::key(Qt::Key_C, Qt::ControlModifier);
        Hand::key(Qt::Key_V, Qt::ControlModifier | Qt::AltModifier); // in place
        QVERIFY(isDragged(pasted, {100, 20}, 1));
        Hand left({shape({line}), shape({corner()})});
        Hand::key(Qt::Key_A, Qt::ControlModifier);
        left.click({100, 50}, Qt::ShiftModifier); // deselects the other one
        QVERIFY(isDragged(left, {100, 20}, 0));
    }
    void clickedAndBoxedPathsAreShownAlike()
    {
        Hand hand({shape({corner()})});
        hand.canvas.setCapsuleHome(app::CapsuleHome::Off); // its place depends on the pointer
        hand.click({60, 20});
        const auto clicked = hand.session.inspected();
        hand.canvas.settle();
        const QImage shown = hand.canvas.grab().toImage();
        Hand::key(Qt::Key_Escape);
        hand.drag({10, 10}, {130, 90});
        QCOMPARE(hand.session.inspected(), clicked);
        hand.move({60, 20}, Qt::NoButton); // as after the click
        hand.canvas.settle();
        QCOMPARE(hand.canvas.grab().toImage(), shown);
    }
    void aClickOnTheHandleIsAClick()
    {
        Hand hand({shape({{{20, 20}, {{{100, 20}}}, false}})});
        hand.click({60, 20});
        hand.click({100, 20});
        QCOMPARE(hand.session.selection().size(), std::size_t(1));
        QCOMPARE(hand.session.history.count(), 0);
    }
    void aSideOfAShapeHasNoHandles()
    {
        Hand hand({shape({corner()})});
        hand.click({40, 20});
        hand.drag({40, 20}, {50, 40});
        QVERIFY(glm::distance(hand.path().segments[0].to - hand.path().start, app::Point(80, 0))
                < 1e-9); // the whole object moved
    }
    void shiftTurnsTheLineInSteps()
    {
        Hand hand({shape({{{20, 20}, {{{100, 20}}}, false}})});
        hand.click({60, 20});
        hand.drag({100, 20}, {98, 60}, Qt::ShiftModifier); // 27°
        const auto line = hand.path();
        QCOMPARE(line.start, app::Point(20, 20));
        const app::Point way = line.segments[0].to - line.start;
        QVERIFY(std::abs(std::atan2(way.y, way.x) - std::numbers::pi / 6) < 1e-9);
    }
    void clickWithShiftStillDeselects()
    {
        Hand hand({shape({{{20, 20}, {{{100, 20}}}, false}})});
        hand.click({60, 20});
        hand.click({100, 20}, Qt::ShiftModifier);
        QVERIFY(hand.session.selection().empty());
    }
    void altKeepsTheMiddle()
    {
        Hand hand({shape({{{20, 50}, {{{100, 50}}}, false}})});
        hand.click({60, 50});
        hand.drag({100, 50}, {100, 70}, Qt::AltModifier);
        QVERIFY(hand.isNear(hand.path().segments[0].to, {100, 70}));
        QVERIFY(hand.isNear(hand.path().start, {20, 30}));
        Hand::type("60<90\n"); // the whole length
        QVERIFY(glm::distance(hand.path().segments[0].to, app::Point(60, 20)) < 1e-9);
        QVERIFY(glm::distance(hand.path().start, app::Point(60, 80)) < 1e-9);
    }
    void numbersChangeTheLastDrag()
    {
        Hand hand({shape({{{20, 20}, {{{100, 20}}}, false}})});
        const app::Variant before = hand.session.variant();
        hand.click({60, 20});
        hand.drag({100, 20}, {110, 60});
        Hand::type("50<0\n");
        QCOMPARE(hand.path().segments[0].to, app::Point(70, 20));
        Hand::type("30\n");
        QCOMPARE(hand.path().segments[0].to, app::Point(50, 20));
        QCOMPARE(hand.session.history.count(), 1);
        QCOMPARE(hand.session.variant(), before);
        QVERIFY(hand.session.inspected().has_value()); // the ends are still shown
        Hand::type("7");
        Hand::key(Qt::Key_Escape);
        QCOMPARE(hand.path().segments[0].to, app::Point(50, 20));
        QVERIFY(hand.session.inspected().has_value());
    }
    void anEndSnapsToOtherLinesOnly()
    {
        Hand hand({shape({{{20, 20}, {{{100, 20}}}, false}}),
                   shape({{{120, 40}, {{{150, 40}}}, false}})});
        hand.canvas.setSnapping(app::SnapTo::Nothing.with("ends"));
        hand.click({60, 20});
        const double pixel = 1 / hand.canvas.view().zoom;
        const app::Point little(100 + 6 * pixel, 20 + 3 * pixel); // near its old place
        hand.drag({100, 20}, little);
        QVERIFY(hand.isNear(hand.path().segments[0].to, little));
        hand.drag(hand.path().segments[0].to, {120 + 3 * pixel, 40});
        QCOMPARE(hand.path().segments[0].to, app::Point(120, 40));
    }
    void aLineOfNoLengthIsRefused()
    {
        Hand hand(
            {shape({{{20, 20}, {{{100, 20}}}, false}}), shape({{{20, 20}, {{{20, 80}}}, false}})});
        hand.canvas.setSnapping(app::SnapTo::Nothing.with("ends"));
        const QSignalSpy refused(&hand.session, &app::Session::refused);
        hand.click({60, 20});
        hand.drag({100, 20}, {20, 20}); // snaps to the end of the other line
        QCOMPARE(refused.size(), 1);
        QCOMPARE(hand.path().segments[0].to, app::Point(100, 20));
        QCOMPARE(hand.session.history.count(), 0);
    }
};

} // namespace tools_end_drag_test

TEST_CLASS(tools_end_drag_test::EndDragTest, Widgets)
#include "tests/ui/tools/end_drag_test.moc"

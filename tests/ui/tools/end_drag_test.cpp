// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/tools/hand.h"

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
};

QTEST_MAIN(EndDragTest)
#include "end_drag_test.moc"

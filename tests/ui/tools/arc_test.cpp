// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/circle_arc.h"

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_arc_test {

// Arcs with mouse and keys.
class ArcTest : public QObject {
    Q_OBJECT

    struct ArcHand : Hand {
        ArcHand() : Hand({}) { canvas.setTool("arc"); }
        std::size_t count() { return session.now().objects().size(); }
        app::Point end() { return path().segments.back().to; }
        /// The point of the path between its curves, or in the middle of its only one.
        app::Point middle()
        {
            const auto& s = path().segments;
            if (s.size() % 2 == 0)
                return s[s.size() / 2 - 1].to;
            const std::size_t i = s.size() / 2;
            const app::Point from = i == 0 ? path().start : s[i - 1].to;
            return app::Bezier{from, s[i].control1, s[i].control2, s[i].to}.at(0.5);
        }
        void clickThrice(app::Point a, app::Point b, app::Point c)
        {
            for (const app::Point p : {a, b, c}) {
                move(p, {});
                click(p);
            }
        }
    };
    static bool same(const app::Point& a, const app::Point& b)
    {
        return glm::distance(a, b) < 1e-9;
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void threeClicksDrawAnArc()
    {
        ArcHand hand;
        hand.clickThrice({20, 50}, {80, 50}, {50, 20});
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(hand.isNear(hand.path().start, {20, 50}) && hand.isNear(hand.end(), {80, 50}));
        QVERIFY(hand.isNear(hand.middle(), {50, 20}));
        QVERIFY(!hand.path().closed);
        QCOMPARE(hand.session.history.undoText(), QString("Draw arc"));
        hand.canvas.undo();
        QCOMPARE(hand.count(), std::size_t(0));
    }
    void aDragDrawsTheChord()
    {
        ArcHand hand;
        hand.drag({20, 50}, {80, 50});
        QCOMPARE(hand.count(), std::size_t(0));
        hand.move({50, 30}, {});
        hand.click({50, 30});
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(hand.isNear(hand.middle(), {50, 30}));
    }
    void numbersMakeItExact()
    {
        ArcHand hand;
        hand.move({50, 20}, {});
        hand.type("20,50\n60,0\n");
        hand.move({50, 40}, {});
        hand.type("50\n");
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.path().start, app::Point(20, 50));
        QCOMPARE(hand.end(), app::Point(80, 50));
        QVERIFY(same(hand.middle(), {50, 90 - 50})); // 30-40-50: the centre is at (50, 90)
        hand.type("30\n");                           // corrects the radius
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(same(hand.middle(), {50, 20}));
        hand.type("<90\n"); // and the angle
        QVERIFY(same(hand.middle(), app::Point(50, 80) - app::Point(0, 30 * std::sqrt(2.0))));
        QCOMPARE(hand.session.history.count(), 1);
    }
    void shiftMakesAHalfCircle()
    {
        ArcHand hand;
        hand.clickThrice({20, 50}, {80, 50}, {50, 50});
        QCOMPARE(hand.count(), std::size_t(0)); // three points on a line: the gesture goes on
        hand.move({51, 19}, {}, Qt::ShiftModifier);
        hand.click({51, 19}, Qt::ShiftModifier);
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(same(hand.middle(), (hand.path().start + hand.end()) * 0.5
                                        - app::Point(0, (hand.end().x - hand.path().start.x) / 2)));
    }
    void byItsCentreWithTheKeyC()
    {
        ArcHand hand;
        const QString hint = hand.canvas.toolHint();
        Hand::key(Qt::Key_C);
        QVERIFY(hand.canvas.toolHint() != hint);
        hand.move({50, 20}, {});
        hand.type("50,50\n20<30\n-120\n");
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(same(hand.path().start, {50 + 10 * std::sqrt(3.0), 40}));
        QVERIFY(same(hand.end(), {50, 70}));
        QCOMPARE(hand.path().segments.size(), std::size_t(2));
        hand.type("360\n");
        QVERIFY(hand.path().closed);
        hand.canvas.setTool("line");
        hand.canvas.setTool("arc");
        hand.clickThrice({50, 50}, {70, 50}, {50, 30}); // still by its centre
        QVERIFY(hand.isNear(hand.paths(1).front().segments.back().to, {50, 30}));
    }
    void theWayThatIsChosenInTheBarHoldsForTypedPoints()
    {
        ArcHand hand;
        hand.canvas.keepNumbers("arc", {1.0}); // as the options bar does
        hand.type("50,50\n20<30\n-120\n");
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(same(hand.path().start, {50 + 10 * std::sqrt(3.0), 40}));
        QVERIFY(same(hand.end(), {50, 70}));
    }
    void escKeepsTheWayOfDrawing()
    {
        for (const bool byCentre : {false, true}) {
            ArcHand hand;
            if (byCentre)
                Hand::key(Qt::Key_C);
            hand.click({10, 10});
            Hand::key(Qt::Key_Escape);
            hand.clickThrice({50, 50}, {70, 50}, {50, 30});
            QVERIFY(
                hand.isNear(hand.path().start, byCentre ? app::Point(70, 50) : app::Point(50, 50)));
        }
    }
    void altAtTheFirstClickIsTheCentreOnce()
    {
        ArcHand hand;
        hand.click({50, 50}, Qt::AltModifier);
        for (const app::Point p : {app::Point(70, 50), {50, 30}}) {
            hand.move(p, {});
            hand.click(p);
        }
        QVERIFY(hand.isNear(hand.path().start, {70, 50}) && hand.isNear(hand.end(), {50, 30}));
        QCOMPARE(hand.path().segments.size(), std::size_t(1));
        hand.clickThrice({20, 50}, {80, 50}, {50, 20});
        QVERIFY(hand.isNear(hand.paths(1).front().segments.back().to, {80, 50}));
    }
    void thePointerLeadsAroundTheCentre()
    {
        for (const bool clockwise : {false, true}) {
            ArcHand hand;
            Hand::key(Qt::Key_C);
            hand.clickThrice({50, 50}, {70, 50}, {70, 50});
            QCOMPARE(hand.count(), std::size_t(0));
            for (int degrees = 10; degrees <= 270; degrees += 10) {
                const double angle = glm::radians(clockwise ? double(degrees) : -degrees);
                hand.move(app::Point(50, 50) + 30.0 * app::Point(std::cos(angle), std::sin(angle)),
                          {});
            }
            hand.click({50, clockwise ? 20 : 80});
            QCOMPARE(hand.count(), std::size_t(1));
            QCOMPARE(hand.path().segments.size(), std::size_t(3));
            QVERIFY(hand.isNear(hand.end(), {50, clockwise ? 30 : 70}));
        }
    }
    void undoAndBackspaceTakeBackAPoint()
    {
        ArcHand hand;
        hand.click({10, 10});
        hand.move({30, 10}, {});
        hand.canvas.undo();
        hand.click({20, 50});
        hand.move({33, 33}, {});
        hand.click({33, 33});
        Hand::key(Qt::Key_Backspace);
        for (const app::Point p : {app::Point(80, 50), {50, 20}}) {
            hand.move(p, {});
            hand.click(p);
        }
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(hand.isNear(hand.path().start, {20, 50}) && hand.isNear(hand.end(), {80, 50}));
        QCOMPARE(hand.session.history.count(), 1);
    }
    // One or two points are no arc: nothing of them is kept, neither by Esc nor in the journal.
    void escDiscardsThePointsAndNothingThatIsFinished()
    {
        ArcHand hand;
        hand.clickThrice({20, 50}, {80, 50}, {50, 20});
        hand.click({20, 90});
        hand.click({80, 90});
        QVERIFY(!hand.canvas.pendingObject());
        Hand::key(Qt::Key_Escape);
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.canvas.tool(), std::string_view("arc")); // only the gesture has ended
        hand.move({50, 70}, {});
        hand.click({50, 70}); // the first point of another arc
        QCOMPARE(hand.count(), std::size_t(1));
        Hand::key(Qt::Key_Escape);
        Hand::key(Qt::Key_Escape);
        QCOMPARE(hand.canvas.tool(), std::string_view("select"));
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.session.history.count(), 1);
    }
};

} // namespace tools_arc_test

TEST_CLASS(tools_arc_test::ArcTest, Widgets)
#include "tests/ui/tools/arc_test.moc"

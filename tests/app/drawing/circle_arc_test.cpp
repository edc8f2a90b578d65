// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/bezier.h"
#include "app/drawing/circle_arc.h"
#include "app/drawing/readout.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <random>

#include "tests/test_class.h"

namespace drawing_circle_arc_test {

using namespace app;

class CircleArcTest : public QObject {
    Q_OBJECT

    static constexpr double error = 3e-4; // of a curve, relative to the radius
    static bool near(const Point& a, const Point& b) { return glm::distance(a, b) < 1e-9; }

    static Readout through(const Point& from, const Point& to)
    {
        return Readout({&arcMeasure(), {from, to}, {0, 0}, {Unit::Mm, 1}});
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void threePointsLieOnTheArc()
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> place(-100, 100);
        for (int i = 0; i < 1000; ++i) {
            const Point a(place(random), place(random)), b(place(random), place(random)),
                on(place(random), place(random));
            const auto arc = arcThrough(a, b, on);
            QVERIFY(arc);
            const double radius = radiusOf(*arc);
            QVERIFY(std::abs(glm::distance(arc->centre, b) - radius) < 1e-9 * radius);
            QVERIFY(std::abs(glm::distance(arc->centre, on) - radius) < 1e-9 * radius);
            const auto again = arcThrough(a, b, middleOf(*arc));
            QVERIFY(again && std::abs(again->degrees - arc->degrees) < 1e-6);
            double nearest = HUGE_VAL;
            Point from = a;
            const Subpath path = pathOf(*arc);
            QCOMPARE(path.start, a);
            QCOMPARE(path.segments.back().to, b);
            for (const PathSegment& s : path.segments) {
                for (int k = 0; k <= 100; ++k) {
                    const Point p = Bezier{from, s.control1, s.control2, s.to}.at(k / 100.0);
                    QVERIFY(std::abs(glm::distance(p, arc->centre) - radius) < error * radius);
                    nearest = std::min(nearest, glm::distance(p, on));
                }
                from = s.to;
            }
            QVERIFY(nearest < 0.02 * radius); // it is the arc of the two that has the point
        }
    }
    void pointsOnALineHaveNoArc()
    {
        for (const Point& on : {Point(5, 5), {20, 20}, {-3, -3}, {0, 0}, {10, 10}})
            QVERIFY(!arcThrough({0, 0}, {10, 10}, on));
        QVERIFY(!arcThrough({1, 1}, {1, 1}, {5, 7}));
    }
    void anglesAreCounterclockwiseOnScreen()
    {
        const CircleArc arc = arcAround({10, 10}, {15, 10}, 90);
        QCOMPARE(arc.to, Point(10, 5));
        QVERIFY(near(middleOf(arc), Point(10, 10) + Point(1, -1) * (5 / std::sqrt(2.0))));
        QVERIFY(near(arcOfAngle(arc.from, arc.to, 90).centre, {10, 10}));
        QVERIFY(near(arcOfAngle(arc.from, arc.to, -270).centre, {10, 10}));
        QVERIFY(near(middleOf(arcAround({10, 10}, {15, 10}, -359)),
                     arcAround({10, 10}, {15, 10}, -179.5).to));
        const Subpath circle = pathOf(arcAround({10, 10}, {15, 10}, 360));
        QVERIFY(circle.closed && circle.segments.size() == 4);
        QCOMPARE(circle.segments.back().to, circle.start);
    }
    void radiusHoldsOnThePointersSide()
    {
        Readout readout = through({0, 0}, {30, 0});
        readout.type("25");
        for (const auto& [pointer, degrees] : {std::pair{Point(15, -3), -1},
                                               {Point(15, 3), 1},
                                               {Point(15, -40), -2},
                                               {Point(15, 40), 2}}) {
            const auto arc = arcThrough({0, 0}, {30, 0}, readout.end(pointer));
            QVERIFY(arc && std::abs(radiusOf(*arc) - 25) < 1e-9);
            QVERIFY((arc->degrees > 0) == (degrees > 0));
            QCOMPARE(std::abs(arc->degrees) > 180, std::abs(degrees) == 2);
        }
        QVERIFY(readout.accept({15, -3}));
        readout.type("15");
        QVERIFY(near(readout.end({15, -3}), {15, -15}));
        readout.type("14.9");
        QVERIFY(!readout.accept({15, -3}));
        QCOMPARE(readout.error(),
                 "The radius must be at least half the distance between the ends.");
    }
    void angleHoldsAndReplacesATypedRadius()
    {
        Readout readout = through({0, 0}, {30, 0});
        readout.type("25");
        readout.activate(1);
        readout.type("180");
        QVERIFY(near(readout.end({15, 3}), {15, 15}));
        readout.type("-180");
        QVERIFY(near(readout.end({15, 3}), {15, -15}));
        QCOMPARE(readout.number(0, readout.end({15, 3})), "15.00\u00a0mm");
        readout.type("0");
        QVERIFY(!readout.accept({15, 3}));
        readout.type("360");
        QVERIFY(!readout.accept({15, 3}));
    }
    void lockedRadiusRefusesAnAngle()
    {
        Readout readout = through({0, 0}, {30, 0});
        readout.type("25");
        QVERIFY(readout.lock());
        readout.type("90");
        QVERIFY(!readout.accept({15, 3}));
        QCOMPARE(readout.error(), "Radius is locked and determines this number. Unlock it first.");
        const auto arc = arcThrough({0, 0}, {30, 0}, readout.end({15, 3}));
        QVERIFY(arc && std::abs(radiusOf(*arc) - 25) < 1e-9);
    }
    void sweepGoesTheWayOfItsSign()
    {
        for (const Turn turn : {Turn::Clockwise, Turn::Counterclockwise}) {
            Readout readout({&sweepMeasure(turn), {{0, 0}, {10, 0}}, {0, 0}, {Unit::Mm, 1}});
            const double pointed = readout.result({0, -7}).numbers[0];
            QCOMPARE(pointed, turn == Turn::Clockwise ? -270.0 : 90.0);
            readout.type("-33");
            QCOMPARE(readout.result({0, -7}).numbers[0], -33.0);
            readout.type("361");
            QVERIFY(!readout.accept({0, -7}));
        }
    }
};

} // namespace drawing_circle_arc_test

TEST_CLASS(drawing_circle_arc_test::CircleArcTest, None)
#include "tests/app/drawing/circle_arc_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/whole_curve.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/test_class.h"

namespace cut_whole_curve_test {

using namespace app;

namespace {

Subpath halfCircle(std::initializer_list<double> cuts)
{
    Subpath path{{50, 0}, {}, false};
    std::vector<PathSegment> quarters;
    appendCurves(quarters, {{0, 0}, {50, 0}, {0, 50}, 0, std::numbers::pi}, path.start, {-50, 0});
    Point from = path.start;
    for (const PathSegment& s : quarters) {
        const Bezier curve{from, s.control1, s.control2, s.to};
        double last = 0;
        const auto add = [&](double t) {
            const Bezier part = curve.part(std::exchange(last, t), t);
            path.segments.push_back({part.to, part.control1, part.control2, true});
        };
        for (const double cut : cuts)
            add(cut);
        add(1);
        from = s.to;
    }
    return path;
}

} // namespace

class WholeCurveTest : public QObject {
    Q_OBJECT

private slots:
    void twoPartsAreJoined()
    {
        std::mt19937 chance(3);
        const auto number = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(chance);
        };
        const auto point = [&] { return Point(number(0, 100), number(0, 100)); };
        for (int i = 0; i < 1000; ++i) {
            const Bezier curve{point(), point(), point(), point()};
            const double t = number(0.05, 0.95);
            const auto whole = joined(curve.part(0, t), curve.part(t, 1));
            QVERIFY(whole);
            QVERIFY(glm::distance(whole->control1, curve.control1) < 1e-6);
            QVERIFY(glm::distance(whole->control2, curve.control2) < 1e-6);
            QVERIFY(!joined(curve, {curve.to, point(), point(), point()}));
        }
    }

    void quartersOfACircleAreNot()
    {
        const Subpath circle = halfCircle({});
        QVERIFY(!goesOnAfter(circle, 0));
        QVERIFY(!goesOnAfter(circle, 1)); // nothing follows
    }

    void dividedArcsAreOfTheirCircle()
    {
        for (const auto& cuts :
             {std::initializer_list<double>{0.3}, {0.2, 0.25, 0.9}, {0.01, 0.5}}) {
            const Subpath path = halfCircle(cuts);
            const std::size_t parts = cuts.size() + 1;
            for (std::size_t i = 0; i < path.segments.size(); ++i) {
                QCOMPARE(goesOnAfter(path, i), i % parts + 1 != parts);
                const auto ellipse = ellipseAt(path, i);
                QVERIFY(ellipse && ellipse->isCertain);
                for (const Point& p : {Point(50, 0), Point(0, 50), Point(-30, -40)})
                    QVERIFY(glm::distance(onEllipse(ellipse->ellipse, p), p) < 1e-6);
            }
        }
    }
};

} // namespace cut_whole_curve_test

TEST_CLASS(cut_whole_curve_test::WholeCurveTest, None)
#include "tests/app/cut/whole_curve_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/places.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

#include "tests/test_class.h"

namespace view_snapping_places_test {

using app::Point;
using clipping::Segment;

namespace {

std::int64_t cross(const Point& u, const Point& v)
{
    return std::int64_t(u.x) * std::int64_t(v.y) - std::int64_t(u.y) * std::int64_t(v.x);
}

// A quarter of a circle, as drawing programs store it.
app::Bezier quarter(const Point& centre, double radius)
{
    const double k = 0.5522847498307936 * radius;
    return {centre + Point(radius, 0), centre + Point(radius, k), centre + Point(k, radius),
            centre + Point(0, radius)};
}

} // namespace

class PlacesTest : public QObject {
    Q_OBJECT

private slots:
    // Whole coordinates, so that the quotients are exact rational numbers.
    void crossingsAreThoseOfRationalArithmetic()
    {
        std::mt19937_64 random(1);
        std::uniform_int_distribution<int> any(-1000, 1000);
        const auto point = [&] { return Point(any(random), any(random)); };
        int found = 0;
        for (int round = 0; round < 100'000; ++round) {
            const Segment one{point(), point()}, two{point(), point()};
            const Point r = one.b - one.a, s = two.b - two.a;
            const std::int64_t whole = cross(r, s);
            const auto within = [&](std::int64_t share) {
                return whole > 0 ? share >= 0 && share <= whole : share <= 0 && share >= whole;
            };
            const std::int64_t t = cross(two.a - one.a, s);
            const bool expected = whole != 0 && within(t) && within(cross(two.a - one.a, r));
            const auto shared = app::crossing(one, two);
            QCOMPARE(shared.has_value(), expected);
            if (!expected)
                continue;
            ++found;
            for (int axis = 0; axis < 2; ++axis) {
                const long double exact =
                    one.a[axis] + static_cast<long double>(r[axis]) * t / whole;
                QVERIFY(std::abs(double(exact - (*shared)[axis])) <= 4 * 0x1p-43); // ulps of 1000
            }
        }
        QVERIFY(found > 10'000);
    }
    void crossingsOfHorizontalAndVerticalLinesAreExact()
    {
        const Segment horizontal{{-7, 0.1}, {93, 0.1}}, vertical{{0.3, -50}, {0.3, 70}};
        QCOMPARE(app::crossing(horizontal, vertical), std::optional(Point(0.3, 0.1)));
        QCOMPARE(app::crossing(vertical, horizontal), std::optional(Point(0.3, 0.1)));
        const auto slanted = app::crossing(Segment{{-3, -5}, {4, 9.1}}, horizontal);
        QCOMPARE(slanted->y, 0.1);
    }
    void parallelAndInfiniteSegmentsDoNotCross()
    {
        const Segment one{{0, 0}, {10, 10}};
        const double inf = std::numeric_limits<double>::infinity();
        QCOMPARE(app::crossing(one, {{1, 0}, {11, 10}}), std::nullopt);
        QCOMPARE(app::crossing(one, {{2, 2}, {5, 5}}), std::nullopt);
        QCOMPARE(app::crossing(one, {{3, 3}, {3, 3}}), std::nullopt);
        QCOMPARE(app::crossing(one, {{0, 10}, {inf, 0}}), std::nullopt);
    }
    void feetArePerpendicularAndOnTheSegment()
    {
        std::mt19937_64 random(2);
        std::uniform_real_distribution<double> any(-1000, 1000);
        const auto point = [&] { return Point(any(random), any(random)); };
        int found = 0;
        for (int round = 0; round < 10'000; ++round) {
            const Segment s{point(), point()};
            const Point from = point();
            const double t = glm::dot(from - s.a, s.b - s.a) / glm::dot(s.b - s.a, s.b - s.a);
            const auto foot = app::footOn(s, from);
            QCOMPARE(foot.has_value(), t >= 0 && t <= 1);
            if (!foot)
                continue;
            ++found;
            const Point along = glm::normalize(s.b - s.a);
            QVERIFY(std::abs(glm::dot(*foot - from, along)) < 1e-9);
            QVERIFY(glm::distance(*foot, s.a + along * glm::dot(*foot - s.a, along)) < 1e-9);
        }
        QVERIFY(found > 1000);
        QCOMPARE(app::footOn({{0.1, -9}, {0.1, 9}}, {7, 0.3}), std::optional(Point(0.1, 0.3)));
        QCOMPARE(app::footOn({{0, 0}, {9, 0}}, {3, 0}), std::nullopt); // already on it
    }
    void placesOnACurveAreOnIt()
    {
        const app::Bezier arc = quarter({5, 6}, 10);
        const Point pointer(5 + 12 * std::cos(0.7), 6 + 12 * std::sin(0.7));
        const Point nearest = app::nearestOn(arc, pointer);
        QVERIFY(std::abs(glm::distance(nearest, Point(5, 6)) - 10) < 0.003); // as round as it is
        for (int i = 0; i <= 1000; ++i)
            QVERIFY(glm::distance(nearest, pointer)
                    <= glm::distance(arc.at(i / 1000.0), pointer) + 1e-9);
        const auto feet = app::feetOn(arc, {5 + 30 * std::cos(0.4), 6 + 30 * std::sin(0.4)});
        QCOMPARE(feet.size(), std::size_t(1));
        QVERIFY(glm::distance(feet[0], Point(5 + 10 * std::cos(0.4), 6 + 10 * std::sin(0.4)))
                < 0.02);
    }
    void circularArcsHaveACentre()
    {
        const auto centre = app::arcCentre(quarter({5, 6}, 10));
        QVERIFY(centre && glm::distance(*centre, Point(5, 6)) < 1e-9);
        QVERIFY(app::arcCentre(quarter({5, 6}, 10).part(0.2, 0.7)));
        QVERIFY(!app::arcCentre({{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
        QVERIFY(!app::arcCentre({{10, 0}, {10, 3}, {3, 5}, {0, 5}})); // a quarter of an ellipse
        QVERIFY(!app::arcCentre({{0, 0}, {5, 9}, {-5, 9}, {0, 0}}));
    }
};

} // namespace view_snapping_places_test

TEST_CLASS(view_snapping_places_test::PlacesTest, None)
#include "tests/app/view/snapping/places_test.moc"

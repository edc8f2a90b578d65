// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and rays at convex polygons against long segments on the same lines, whose results are
// unique, bit for bit; on whole numbers, so that the ends of these segments are exact.
#include <QTest>

#include <clearcut/clip.h>
#include <cmath>

#include "tests/clipping/polygon/shapes.h"
#include "tests/clipping/same_bits.h"
#include "tests/test_class.h"

namespace polygon_line_or_ray_test {

using namespace clearcut;

namespace {

constexpr double far = 1024; // times b - a: beyond every polygon here

Segment lineOf(const Segment& s) { return {s.a - far * (s.b - s.a), s.b + far * (s.b - s.a)}; }
Segment rayOf(const Segment& s) { return {s.a, s.b + far * (s.b - s.a)}; }

/// Polygons of 1 to 12 corners and pairs of points, all of whole numbers from -8 to 8: many touch
/// or follow an edge, or begin on one. With a negative unit, zeros are -0.
struct Case {
    ConvexWindow polygon;
    std::vector<Segment> pairs;
};
Case someCase(RandomNumbers& random, double unit)
{
    const auto point = [&] {
        const int x = random.integer(-8, 8);
        return unit * glm::dvec2(x, random.integer(-8, 8));
    };
    std::vector<glm::dvec2> corners;
    for (int i = random.integer(1, 12); i > 0; --i)
        corners.push_back(point());
    Case result{ConvexWindow(hullOf(corners).corners), {}};
    while (result.pairs.size() < 100)
        if (const Segment s{point(), point()}; s.a != s.b)
            result.pairs.push_back(s);
    return result;
}

template <class Shape>
std::vector<Shape> through(const std::vector<Segment>& pairs)
{
    std::vector<Shape> all;
    for (const auto& [a, b] : pairs)
        all.push_back({a, b});
    return all;
}

bool same(const std::vector<Clipped>& p, const std::vector<Clipped>& q)
{
    return std::ranges::equal(p, q, [](auto& a, auto& b) { return sameBits(a, b); });
}

} // namespace

class LineOrRayTest : public QObject {
    Q_OBJECT

private slots:
    void theyAreLongSegments_data()
    {
        QTest::addColumn<double>("unit");
        for (const double unit : {1.0, -1.0, 349525.0, 0x1p-1000, 0x1p1000})
            QTest::addRow("%g", unit) << unit;
    }
    void theyAreLongSegments()
    {
        QFETCH(double, unit);
        RandomNumbers random(5);
        std::size_t lines = 0, rays = 0;
        for (int i = 0; i < 80; ++i) {
            const auto& [polygon, pairs] = someCase(random, unit);
            QVERIFY(bool(polygon));
            std::vector<Segment> longLines, longRays;
            for (const Segment& s : pairs)
                longLines.push_back(lineOf(s)), longRays.push_back(rayOf(s));
            const auto ofLines = clipAll(longLines, polygon), ofRays = clipAll(longRays, polygon);
            QVERIFY(same(clipAll(through<Line>(pairs), polygon), ofLines));
            QVERIFY(same(clipAll(through<Ray>(pairs), polygon), ofRays));
            lines += ofLines.size(), rays += ofRays.size();
        }
        QVERIFY(lines > 1'600 && rays > 800 && rays < lines);
    }

    void oneIsClippedAsMany()
    {
        RandomNumbers random(6);
        const auto& [polygon, pairs] = someCase(random, 1);
        const auto lines = clipAll(asLines(SegmentsView<double>(pairs)), polygon);
        auto next = lines.begin();
        for (std::uint32_t i = 0; i < pairs.size(); ++i) {
            const auto line = clip(Line{pairs[i].a, pairs[i].b}, polygon);
            QCOMPARE(line.has_value(), next != lines.end() && next->source == i);
            if (line)
                QVERIFY(sameBits(*line, next++->segment));
        }
        const auto diamond = ConvexPolygon::from({{2, 0}, {0, 2}, {-2, 0}, {0, -2}});
        QVERIFY(clip(Ray{{0, 0}, {1, 1}}, diamond) == (Segment{{0, 0}, {1, 1}}));
        QVERIFY(!clip(Ray{{3, 0}, {4, 0}}, diamond));
        QVERIFY(clip(BasicLine<float>{{-9, 1}, {-8, 1}}, diamond)
                == (BasicSegment<float>{{-1, 1}, {1, 1}}));
        QVERIFY(clip(BasicRay<float>{{0, 1}, {-8, 1}}, diamond)
                == (BasicSegment<float>{{0, 1}, {-1, 1}}));
    }

    void withoutADirectionOrAPolygonNothingIsVisible()
    {
        const auto square = ConvexPolygon::from({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
        const double infinite = std::numeric_limits<double>::infinity();
        QVERIFY(!clip(Line{{0.5, 0.5}, {0.5, 0.5}}, square));
        QVERIFY(!clip(Ray{{0.5, 0.5}, {0.5, 0.5}}, square));
        QVERIFY(!clip(Line{{0, 0}, {infinite, 1}}, square));
        QVERIFY(!clip(Ray{{0, 0}, {1, std::nan("")}}, square));
        QVERIFY(!clip(Line{{0, 0}, {1, 1}}, ConvexWindow{}));
        QVERIFY(!clip(Ray{{0, 0}, {1, 1}}, ConvexWindow{}));
    }

    // As for a segment, an end that rounding brings back to the input's is not a cut.
    void anEndThatIsRoundedBackIsNoCut()
    {
        const auto wedge = ConvexPolygon::from({{0, 0}, {3, 1}, {0, 1}});
        const glm::dvec2 outside{1, 1.0 / 3}; // less than a third, which is on the edge
        const auto pieces = clipAll(std::vector{Ray{outside, {1, 2}}}, wedge);
        QCOMPARE(pieces.size(), 1u);
        QVERIFY(pieces[0].segment.a == outside && polygonEdgeOfA(pieces[0].cut) == 0);
        const auto segments = clipAll(std::vector{Segment{outside, {1, 2}}}, wedge);
        QVERIFY(same(pieces, segments));
    }

    // The ends lie between the corners of their edges, however far the two points are.
    void farPointsDefineALineToo()
    {
        const auto triangle = ConvexPolygon::from({{0, 0}, {3, 0}, {0, 3}});
        for (const double x : {1e10, 1e150, 1e300}) {
            const auto level = clip(Line{{x, 1}, {2 * x, 1}}, triangle);
            QVERIFY(level == (Segment{{0, 1}, {2, 1}}));
            const auto back = clip(Ray{{x, x}, {x / 2, x / 2}}, triangle);
            QVERIFY(back == (Segment{{1.5, 1.5}, {0, 0}}));
        }
    }
};

} // namespace polygon_line_or_ray_test

TEST_CLASS(polygon_line_or_ray_test::LineOrRayTest, None)
#include "tests/clipping/polygon/line_or_ray_test.moc"

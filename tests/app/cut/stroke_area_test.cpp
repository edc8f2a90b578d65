// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/stroke_area.h"
#include "app/document/arc_curves.h"
#include "app/document/document_builder.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/test_class.h"

namespace cut_stroke_area_test {

using namespace app;

namespace {

constexpr double tolerance = 0.01;

/// The numbers of turns of closed polygons around a point.
int windings(const std::vector<std::vector<Point>>& rings, const Point& p)
{
    int turns = 0;
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i] - p, b = ring[(i + 1) % ring.size()] - p;
            if ((a.y <= 0) != (b.y <= 0) && (a.x * b.y - a.y * b.x > 0) == (b.y > a.y))
                turns += b.y > a.y ? 1 : -1;
        }
    return turns;
}

std::vector<Point> cornersOf(const Subpath& path, double within)
{
    std::vector<Chord> chords;
    flatten(path, within, chords);
    std::vector<Point> corners;
    for (const Chord& chord : chords)
        corners.push_back(chord.segment.a);
    corners.push_back(chords.back().segment.b);
    return corners;
}

std::vector<std::vector<Point>> polygonsOf(const std::vector<Subpath>& paths)
{
    std::vector<std::vector<Point>> polygons;
    for (const Subpath& path : paths)
        polygons.push_back(cornersOf(path, tolerance / 20));
    return polygons;
}

double distanceTo(const clipping::Segment& line, const Point& p)
{
    const Point along = line.b - line.a;
    const double length2 = glm::dot(along, along);
    const double t =
        length2 > 0 ? std::clamp(glm::dot(p - line.a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(line.a + along * t, p);
}

/// A few lines and curves; some of them turn within a pen's width.
std::vector<Subpath> randomPath(std::mt19937& chance)
{
    const auto point = [&] {
        std::uniform_real_distribution<double> along(0, 100);
        return Point(along(chance), along(chance));
    };
    std::vector<Subpath> paths(1 + chance() % 2);
    for (Subpath& path : paths) {
        path.start = point();
        const std::size_t count = 1 + chance() % 4;
        for (std::size_t i = 0; i < count; ++i) {
            PathSegment next{point()};
            if (chance() % 3 > 0) {
                const Point from = i == 0 ? path.start : path.segments.back().to;
                next = {next.to, chance() % 5 == 0 ? from : point(),
                        chance() % 5 == 0 ? next.to : point(), true};
            }
            path.segments.push_back(next);
        }
        path.closed = chance() % 2 == 0;
    }
    return paths;
}

Style pen(double width, Cap cap = Cap::Butt, Join join = Join::Miter)
{
    return {.stroke = Colour{0, 0, 0}, .width = width, .cap = cap, .join = join};
}

double areaOf(const std::vector<Subpath>& paths)
{
    double twice = 0;
    for (const auto& ring : polygonsOf(paths))
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
            twice += a.x * b.y - a.y * b.x;
        }
    return std::abs(twice) / 2;
}

std::vector<Subpath> strokeOf(const Subpath& path, const Style& style)
{
    return strokeArea(Path(std::vector{path}), style, tolerance);
}

Subpath circle(const Point& centre, double radius)
{
    Subpath path{centre + Point(radius, 0), {}, true};
    appendCurves(path.segments, {centre, {radius, 0}, {0, radius}, 0, 2 * std::numbers::pi},
                 path.start, path.start);
    return path;
}

} // namespace

class StrokeAreaTest : public QObject {
    Q_OBJECT

private slots:
    void aLineIsARectangle()
    {
        const Subpath line{{10, 50}, {{{90, 50}}}, false};
        const auto butt = strokeOf(line, pen(15));
        QCOMPARE(butt.size(), std::size_t(1));
        QCOMPARE(butt[0].segments.size(), std::size_t(3));
        QCOMPARE(areaOf(butt), 80.0 * 15);
        QCOMPARE(areaOf(strokeOf(line, pen(15, Cap::Square))), 95.0 * 15);
        QVERIFY(std::abs(areaOf(strokeOf(line, pen(15, Cap::Round)))
                         - (80 * 15 + std::numbers::pi * 7.5 * 7.5))
                < 0.2);
    }

    void aCircleIsARingOfCurves()
    {
        const auto ring = strokeOf(circle({50, 50}, 30), pen(10));
        QCOMPARE(ring.size(), std::size_t(2));
        for (const Subpath& side : ring) {
            QVERIFY(side.segments.size() <= 4);
            QVERIFY(std::ranges::all_of(side.segments, &PathSegment::curved));
        }
        QVERIFY(std::abs(areaOf(ring) - std::numbers::pi * (35 * 35 - 25 * 25)) < 1);
        QCOMPARE(strokeOf(circle({50, 50}, 4), pen(10)).size(), std::size_t(1)); // no hole
    }

    // 188.5 mm long: twelve dashes of 10 mm, and one of 8.5 mm that ends where the first begins.
    void dashesOnCurvesHaveTheirLengths()
    {
        Style style = pen(10);
        style.dashes = {10, 5};
        const auto dashes = strokeOf(circle({50, 50}, 30), style);
        QCOMPARE(dashes.size(), std::size_t(12));
        for (const Subpath& dash : dashes) {
            QCOMPARE(std::ranges::count_if(dash.segments, &PathSegment::curved) >= 2, true);
            QVERIFY(dash.segments.size() <= 8);
        }
        QVERIFY(std::abs(areaOf(dashes) - 10 * (12 * 10 + (60 * std::numbers::pi - 180))) < 1);
        // Their ends are at right angles to the circle: towards its centre.
        for (const Subpath& dash : dashes) {
            Point from = dash.start;
            for (const PathSegment& segment : dash.segments) {
                if (!segment.curved)
                    QVERIFY(distanceTo({from, from + (segment.to - from) * 10.0}, {50, 50}) < 0.05
                            || distanceTo({from, from - (segment.to - from) * 10.0}, {50, 50})
                                   < 0.05);
                from = segment.to;
            }
        }
    }

    void aPointIsItsCaps()
    {
        const Subpath point{{50, 50}, {}, false}, closed{{50, 50}, {{{50, 50}}}, true};
        for (const Subpath& path : {point, closed}) {
            QVERIFY(strokeOf(path, pen(10)).empty());
            QCOMPARE(areaOf(strokeOf(path, pen(10, Cap::Square))), 100.0);
            QVERIFY(std::abs(areaOf(strokeOf(path, pen(10, Cap::Round))) - 25 * std::numbers::pi)
                    < 0.1);
        }
    }

    void aWideRoundEndIsAsExact()
    {
        const double radius = 200;
        const auto disc = strokeOf({{50, 50}, {}, false}, pen(2 * radius, Cap::Round));
        QVERIFY(std::abs(areaOf(disc) / (radius * radius) - std::numbers::pi) < 1e-4);
        for (const auto& ring : polygonsOf(disc))
            for (const Point& corner : ring)
                QVERIFY(std::abs(glm::distance(corner, {50, 50}) - radius) < tolerance);
    }

    void whatIsNotSeenHasNone()
    {
        const Subpath line{{10, 50}, {{{90, 50}}}, false};
        QVERIFY(strokeOf(line, pen(0)).empty());
        QVERIFY(strokeOf(line, {}).empty());
        QVERIFY(strokeArea({}, pen(1), tolerance).empty());
    }

    // With round caps and joins it is what is near the path.
    void itIsWhatIsNearThePath()
    {
        std::mt19937 chance(1);
        for (int trial = 0; trial < 200; ++trial) {
            const auto paths = randomPath(chance);
            const double half = std::uniform_real_distribution<double>(0.5, 12)(chance);
            const auto area =
                strokeArea(Path(paths), pen(2 * half, Cap::Round, Join::Round), tolerance);
            const auto polygons = polygonsOf(area);
            std::vector<Chord> chords;
            for (const Subpath& path : paths)
                flatten(path, tolerance / 20, chords);
            for (int i = 0; i < 300; ++i) {
                std::uniform_real_distribution<double> along(-15, 115);
                const Point p(along(chance), along(chance));
                double away = 1e9;
                for (const Chord& chord : chords)
                    away = std::min(away, distanceTo(chord.segment, p));
                const int turns = windings(polygons, p);
                QVERIFY(turns == 0 || std::abs(turns) == 1); // so both fill rules do
                if (std::abs(away - half) > tolerance)
                    QVERIFY2((turns != 0) == (away < half),
                             qPrintable(QStringLiteral("trial %1: %2 from the path, half %3")
                                            .arg(trial)
                                            .arg(away)
                                            .arg(half)));
            }
        }
    }

    void aFilledObjectBecomesAGroup()
    {
        DocumentBuilder builder;
        builder.open({.kind = Container::Kind::Layer});
        Object filled{Path(std::vector{circle({50, 50}, 20)}), pen(2)};
        filled.style.fill = Colour{255, 0, 0};
        filled.particulars.id = "disc";
        builder.add(filled);
        builder.close();
        Document document = builder.take(Page{.size = {100, 100}});
        const Cut made = strokesAsAreas(document, ObjectRanges(ObjectRange{0, 1}));
        document.apply(made.edit);
        QCOMPARE(document.objects().size(), std::size_t(2));
        const auto disc = document.objects()[0], ring = document.objects()[1];
        QVERIFY(!disc.style().stroke && disc.path() == filled.path);
        QVERIFY(!ring.style().stroke && ring.style().fill == filled.style.stroke);
        const auto group = document.containers().containerOf(1);
        QCOMPARE(document.containers().rangeOf(group).size(), std::size_t(2));
        QCOMPARE(document.containers()[group].svgId, "disc");
    }
};

} // namespace cut_stroke_area_test

TEST_CLASS(cut_stroke_area_test::StrokeAreaTest, None)
#include "tests/app/cut/stroke_area_test.moc"

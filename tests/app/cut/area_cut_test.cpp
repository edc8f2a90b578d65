// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/cut_object.h"
#include "app/document/bezier.h"
#include "app/document/recipe_outline.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/test_class.h"

namespace cut_area_cut_test {

using namespace app;

namespace {

constexpr double tolerance = 1e-3;

AreaLeft cutAt(const Path& path, const ClipRegion& region, FillRule rule = FillRule::NonZero)
{
    std::vector<Chord> chords;
    flatten(path, tolerance, chords);
    return AreaCut(region).left(path, rule, chords);
}

ClipRegion windowAt(const clipping::Window& window, Keep keep = Keep::Inside)
{
    return {{{window, WindowOperation::Add}}, keep};
}

double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

// The signed area under a cubic curve, exactly: the integral of cross(p, p') / 2.
double areaUnder(const Bezier& c)
{
    const Point &p = c.from, &q = c.control1, &r = c.control2, &s = c.to;
    return (6 * cross(p, q) + 3 * cross(p, r) + cross(p, s) + 3 * cross(q, r) + 3 * cross(q, s)
            + 6 * cross(r, s))
           / 20;
}

double areaOf(const std::vector<Subpath>& paths)
{
    double area = 0;
    for (const Subpath& path : paths) {
        Point last = path.start;
        for (const PathSegment& s : path.segments) {
            area +=
                s.curved ? areaUnder({last, s.control1, s.control2, s.to}) : cross(last, s.to) / 2;
            last = s.to;
        }
        area += cross(last, path.start) / 2;
    }
    return area;
}

int curvesIn(const std::vector<Subpath>& paths)
{
    int curves = 0;
    for (const Subpath& path : paths)
        curves += int(std::ranges::count_if(path.segments, &PathSegment::curved));
    return curves;
}

Path circle(const Point& centre, double radius)
{
    const auto outline = outlineOf(EllipseRecipe{centre, Point(radius)});
    return Path({&*outline, 1});
}

// A closed curve around the origin that does not cross itself.
Path blob(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> radius(3, 9);
    constexpr int corners = 7;
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        points.push_back(Point(std::cos(angle), std::sin(angle)) * radius(random));
    }
    Subpath path{points[0], {}, true};
    for (int i = 0; i < corners; ++i) {
        const Point from = points[std::size_t(i)], to = points[std::size_t((i + 1) % corners)];
        if (i % 3 == 2)
            path.segments.push_back({to});
        else
            path.segments.push_back(
                {to, from * 1.1 + (to - from) * 0.3, to * 1.1 - (to - from) * 0.3, true});
    }
    return Path({&path, 1});
}

} // namespace

class AreaCutTest : public QObject {
    Q_OBJECT

private slots:
    void wholeAndNothing()
    {
        const Path path = circle({0, 0}, 5);
        QVERIFY(cutAt(path, windowAt({{-6, -6}, {6, 6}})).whole);
        QVERIFY(cutAt(path, ClipRegion{}).whole);
        const AreaLeft apart = cutAt(path, windowAt({{6, 6}, {9, 9}}));
        QVERIFY(!apart.whole && apart.paths.empty());
        const AreaLeft hole = cutAt(path, windowAt({{-6, -6}, {6, 6}}, Keep::Outside));
        QVERIFY(!hole.whole && hole.paths.empty());
    }

    // The curves end on the window's edges, bit for bit, and on the circle itself.
    void curvesStayCurves()
    {
        const AreaLeft left = cutAt(circle({0, 0}, 5), windowAt({{-9, -9}, {3, 9}}));
        QCOMPARE(left.paths.size(), 1u);
        QCOMPARE(curvesIn(left.paths), 4); // two whole ones, and parts of two
        int onEdge = left.paths[0].start.x == 3;
        for (const PathSegment& segment : left.paths[0].segments)
            if (segment.to.x == 3) {
                ++onEdge;
                QVERIFY(std::abs(std::abs(segment.to.y) - 4) < 2e-3); // of a circle of Béziers
            }
        QCOMPARE(onEdge, 2);
    }

    void insideAndOutsideAreTheWhole()
    {
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> place(-8, 8);
        for (int i = 0; i < 300; ++i) {
            const Path path = blob(random);
            const Point a(place(random), place(random)), b(place(random), place(random));
            const clipping::Window window{glm::min(a, b), glm::max(a, b)};
            const double whole = std::abs(areaOf(path.subpaths()));
            double sum = 0;
            for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                const AreaLeft left = cutAt(path, windowAt(window, keep));
                sum += left.whole ? whole : areaOf(left.paths);
            }
            QVERIFY2(std::abs(sum - whole) < 1e-9 * whole,
                     qPrintable(QStringLiteral("%1: %2 of %3").arg(i).arg(sum).arg(whole)));
        }
    }

    void insideAndOutsideOfARotatedWindowAreTheWhole()
    {
        std::mt19937_64 random(8);
        for (int i = 0; i < 100; ++i) {
            const Path path = blob(random);
            ClipWindows windows;
            windows.list.push_back({.shape = RectangleShape{{{-4, -9}, {3, 5}}, 0.1 + 0.05 * i}});
            const double whole = std::abs(areaOf(path.subpaths()));
            double sum = 0;
            for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                windows.keep = keep;
                const AreaLeft left = cutAt(path, regionOf(windows, tolerance));
                sum += left.whole ? whole : areaOf(left.paths);
            }
            QVERIFY2(std::abs(sum - whole) < 1e-9 * whole,
                     qPrintable(QStringLiteral("%1: %2 of %3").arg(i).arg(sum).arg(whole)));
        }
    }

    void openAndCrossingPathsAreFilledByTheirRule()
    {
        // A square, twice around: even-odd leaves nothing.
        const Subpath twice{
            {0, 0}, {{{4, 0}}, {{4, 4}}, {{0, 4}}, {{0, 0}}, {{4, 0}}, {{4, 4}}, {{0, 4}}}, false};
        const Path path({&twice, 1});
        const ClipRegion half = windowAt({{-1, -1}, {2, 9}});
        QCOMPARE(areaOf(cutAt(path, half).paths), 8.0);
        QCOMPARE(areaOf(cutAt(path, half, FillRule::EvenOdd).paths), 0.0);
    }

    void aHoleStaysAHole()
    {
        const std::vector<Subpath> ring{{{0, 0}, {{{8, 0}}, {{8, 8}}, {{0, 8}}}, true},
                                        {{2, 2}, {{{6, 2}}, {{6, 6}}, {{2, 6}}}, true}};
        const AreaLeft left = cutAt(Path(ring), windowAt({{-1, -1}, {9, 4}}), FillRule::EvenOdd);
        QCOMPARE(areaOf(left.paths), 32.0 - 8);
    }
};

} // namespace cut_area_cut_test

TEST_CLASS(cut_area_cut_test::AreaCutTest, Core)
#include "tests/app/cut/area_cut_test.moc"

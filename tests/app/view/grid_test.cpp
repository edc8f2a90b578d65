// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/grid.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

#include "tests/test_class.h"

namespace view_grid_test {

using app::Grid;
using app::Point;

namespace {

const app::Page page{{-10, 5}, {200, 100}, {200, app::Unit::Mm}, {100, app::Unit::Mm}};
const clipping::Window seen{{3, 7}, {157, 88}};

} // namespace

class GridTest : public QObject {
    Q_OBJECT

    static void addPatterns()
    {
        QTest::addColumn<Grid::Pattern>("pattern");
        QTest::newRow("square") << Grid::Pattern::Square;
        QTest::newRow("diagonal") << Grid::Pattern::Diagonal;
        QTest::newRow("isometric") << Grid::Pattern::Isometric;
        QTest::newRow("own") << Grid::Pattern::Own;
    }

private slots:
    void settingsAreReadBack()
    {
        const Grid grid{true, 2.54, Grid::Pattern::Own, Grid::Marks::Dots, 0.3, -33.5};
        QCOMPARE(Grid::fromText(grid.text()), grid);
        QCOMPARE(Grid::fromText(""), Grid());
        QCOMPARE(Grid::fromText("shown nan -3 1e300 nonsense down=0 angle=nan down="),
                 (Grid{.shown = true}));
        QCOMPARE(Grid::fromText("shown 5 isometric dots"), // as it was saved before
                 (Grid{true, 5, Grid::Pattern::Isometric, Grid::Marks::Dots}));
    }
    void itBeginsAtTheCornerOfThePaper()
    {
        const auto points = app::gridPoints({}, page, 10);
        QCOMPARE(points.nearest({-9, 6}), Point(-10, 5));
        QCOMPARE(points.nearest({24, 41}), Point(20, 45));
        const app::Page inches{{0, 0}, {8, 4}, {8, app::Unit::Inch}, {4, app::Unit::Inch}};
        QCOMPARE(app::gridPoints({.spacing = 25.4}, inches, 100).nearest({3.1, 1.9}), Point(3, 2));
    }
    void anOwnGridHasItsAngleAndSpacings()
    {
        const Grid grid{.spacing = 20, .pattern = Grid::Pattern::Own, .down = 10, .angle = 30};
        const auto points = app::gridPoints(grid, page, 10);
        QVERIFY(glm::distance(points.u, Point(20 * std::sqrt(0.75), -10)) < 1e-9); // upwards
        QVERIFY(glm::distance(points.v, Point(5, 10 * std::sqrt(0.75))) < 1e-9);
        const Grid straight{.spacing = 7, .pattern = Grid::Pattern::Own, .down = 7};
        QCOMPARE(app::gridPoints(straight, page, 10).u, Point(7, 0));
        QCOMPARE(app::gridPoints(straight, page, 10).v, Point(0, 7));
    }
    void nearestIsTheNearestPoint_data() { addPatterns(); }
    void nearestIsTheNearestPoint()
    {
        QFETCH(Grid::Pattern, pattern);
        const auto points = app::gridPoints({.spacing = 7, .pattern = pattern}, page, 10);
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> place(-100, 100);
        for (int round = 0; round < 300; ++round) {
            const Point at(place(random), place(random));
            double least = HUGE_VAL;
            for (int i = -60; i <= 60; ++i)
                for (int j = -60; j <= 60; ++j)
                    least = std::min(least, glm::distance(points.origin + points.u * double(i)
                                                              + points.v * double(j),
                                                          at));
            QVERIFY(glm::distance(points.nearest(at), at) <= least + 1e-9);
        }
    }
    void linesAndDotsAreNeverTooDense()
    {
        for (const double zoom : {1e-9, 0.01, 0.3, 1.0, 40.0, 1e9}) {
            const auto points = app::gridPoints({}, page, zoom);
            QVERIFY(glm::length(points.u) * zoom >= 9.999 && glm::length(points.v) * zoom >= 9.999);
            const clipping::Window screen{Point(0), Point(1300, 800) / zoom};
            QVERIFY(app::gridLines({}, page, zoom, screen).size() < 250);
            QVERIFY(app::gridDots({}, page, zoom, screen).size() < 12'000);
        }
    }
    void absurdPagesAndZoomsEnd()
    {
        for (const double size : {1e-300, 1e-9, 1e9, 1e20, 1e300})
            for (const double zoom : {1e-9, 1.0, 1e9}) {
                const app::Page huge{
                    {-size, size}, {size, size}, {200, app::Unit::Mm}, {100, app::Unit::Mm}};
                const Point corner = huge.min + huge.size - 1.0;
                const clipping::Window screen{corner, corner + Point(1300, 800) / zoom};
                QVERIFY(app::gridLines({}, huge, zoom, screen).size() < 1000);
                QVERIFY(app::gridDots({}, huge, zoom, screen).size() <= 100'000);
            }
    }
    void everyDotIsOnALineOfEachDirection_data() { addPatterns(); }
    void everyDotIsOnALineOfEachDirection()
    {
        QFETCH(Grid::Pattern, pattern);
        const Grid grid{.pattern = pattern};
        const auto dots = app::gridDots(grid, page, 3, seen);
        const auto lines = app::gridLines(grid, page, 3, seen);
        QVERIFY(dots.size() > 80);
        const std::ptrdiff_t expected = pattern == Grid::Pattern::Isometric ? 3 : 2;
        for (const Point& dot : dots) {
            const auto through = std::ranges::count_if(lines, [&](const app::GridLine& line) {
                const Point along = glm::normalize(line.line.b - line.line.a);
                const Point to = dot - line.line.a;
                return std::abs(along.x * to.y - along.y * to.x) < 1e-6;
            });
            // A line may touch the rectangle in a corner only.
            QVERIFY(through == expected || dot.x < 3.01 || dot.y < 7.01);
        }
    }
    void everyFifthLineIsMajor()
    {
        const auto lines = app::gridLines({}, page, 3, {{-11, 20}, {191, 21}});
        std::vector<double> majors;
        for (const app::GridLine& line : lines)
            if (line.major && line.line.a.x == line.line.b.x)
                majors.push_back(line.line.a.x);
        QCOMPARE(majors, (std::vector<double>{-10, 40, 90, 140, 190}));
    }
};

} // namespace view_grid_test

TEST_CLASS(view_grid_test::GridTest, None)
#include "tests/app/view/grid_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Clip windows as straight edges.
#include "app/document/recipe_outline.h"
#include "app/document/window_frame.h"
#include "app/document/window_outline.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

#include "tests/test_class.h"

namespace document_window_outline_test {

using namespace app;

namespace {

PathShape shapeOf(const Recipe& recipe)
{
    const auto outline = outlineOf(recipe);
    return {Path({&*outline, 1}), FillRule::NonZero, recipe};
}

} // namespace

class WindowOutlineTest : public QObject {
    Q_OBJECT

private slots:
    void aRectangleHasTheBitsOfItsBox()
    {
        const auto outline = outlineOf(RectangleShape{{{0.1, 0.2}, {0.7, 1}}}, 1);
        QVERIFY(outline.rings
                == (std::vector<std::vector<Point>>{{{0.1, 0.2}, {0.7, 0.2}, {0.7, 1}, {0.1, 1}}}));
        QVERIFY(outlineOf(RectangleShape{{{1, 0}, {0, 1}}}, 1).rings.empty());
    }
    void aRotatedRectangleKeepsItsCentreAndItsSides()
    {
        const auto corners = cornersOf({{{10, 20}, {16, 28}}, 0.3});
        const auto length = [&](int i, int k) { return glm::distance(corners[i], corners[k]); };
        for (const auto& [from, to, side] :
             {std::tuple(0, 1, 6.0), {1, 2, 8.0}, {2, 3, 6.0}, {3, 0, 8.0}, {0, 2, 10.0}})
            QVERIFY(std::abs(length(from, to) - side) < 1e-12);
        const Point centre = (corners[0] + corners[2]) * 0.5;
        QVERIFY(glm::distance(centre, {13, 24}) < 1e-12);
        const Point side = corners[1] - corners[0]; // angles grow from x towards y
        QVERIFY(std::abs(std::atan2(side.y, side.x) - 0.3) < 1e-12);
    }
    void aCircleIsAnInscribedPolygonWithinTheTolerance()
    {
        for (const double radius : {0.001, 0.5, 10.0, 3000.0}) {
            const auto outline = outlineOf(shapeOf(EllipseRecipe{{7, -3}, {radius, radius}}), 0.01);
            QCOMPARE(outline.rings.size(), 1u);
            const auto& ring = outline.rings[0];
            QVERIFY(ring.size() % 4 == 0);
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point& next = ring[(i + 1) % ring.size()];
                QVERIFY(std::abs(glm::distance(ring[i], {7, -3}) - radius) < 1e-9 * radius + 1e-12);
                const double depth = radius - glm::distance((ring[i] + next) * 0.5, {7, -3});
                QVERIFY(depth < 0.0100001);
            }
            QVERIFY(std::ranges::find(ring, Point(7 + radius, -3)) != ring.end());
        }
    }
    void anEllipseIsNoFartherFromItsPolygonThanTheCircle()
    {
        const Point centre(1, 2), radii(40, 3);
        const auto ring = outlineOf(shapeOf(EllipseRecipe{centre, radii}), 0.01).rings.at(0);
        for (const Point& corner : ring)
            QVERIFY(std::abs(glm::length((corner - centre) / radii) - 1) < 1e-12);
        QVERIFY(ring.size() > 100);
    }
    void absurdTolerancesEnd()
    {
        const auto most = outlineOf(shapeOf(EllipseRecipe{{0, 0}, {1e12, 1e12}}), 1e-12);
        QCOMPARE(most.rings.at(0).size(), 100'000u);
    }
    void curvesAndHolesOfAPathAreFlattened()
    {
        const std::vector<Subpath> paths{
            {{0, 0}, {{{10, 0}}, {{10, 10}, {14, 3}, {14, 7}, true}, {{0, 10}}, {{0, 0}}}, true},
            {{2, 2}, {{{4, 2}}, {{4, 4}}}, false}};
        const auto outline = outlineOf(PathShape{Path(paths), FillRule::EvenOdd}, 0.01);
        QCOMPARE(outline.rule, FillRule::EvenOdd);
        QCOMPARE(outline.rings.size(), 2u);
        QVERIFY(outline.rings[0].size() > 10);
        QVERIFY(outline.rings[0].front() == Point(0, 0) && outline.rings[0].back() == Point(0, 10));
        QVERIFY(outline.rings[1] == (std::vector<Point>{{2, 2}, {4, 2}, {4, 4}}));
    }
};

} // namespace document_window_outline_test

TEST_CLASS(document_window_outline_test::WindowOutlineTest, None)
#include "tests/app/document/window_outline_test.moc"

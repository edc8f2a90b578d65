// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/affine_map.h"
#include "app/document/direction.h"
#include "app/document/recipe.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <limits>

#include "tests/test_class.h"

namespace document_affine_map_test {

using namespace app;

class AffineMapTest : public QObject {
    Q_OBJECT

    static bool near(const Point& a, const Point& b) { return glm::distance(a, b) < 1e-12; }

private slots:
    void theFixedPointStaysInEveryBit()
    {
        const Point about(0.1, -1e7 / 3);
        for (const AffineMap& map :
             {rotation(33.3, about), scaling({1.7, -0.3}, about), horizontalSkew(20, about)})
            QCOMPARE(map(about), about);
    }
    void quarterTurnsAreExact()
    {
        const AffineMap left = rotation(90, {10, 10});
        QCOMPARE(left(Point(13, 10)), Point(10, 7)); // counterclockwise, y grows down
        QCOMPARE(left(Point(10, 7)), Point(7, 10));
        QCOMPARE(rotation(180, {10, 10})(Point(13, 11)), Point(7, 9));
        QCOMPARE(rotation(-270, {10, 10})(Point(13, 10)), Point(10, 7));
    }
    void rotationKeepsLengthsAndTurnsByItsAngle()
    {
        const AffineMap map = rotation(30, {2, 3});
        const Point turned = map(Point(12, 3)) - map(Point(2, 3));
        QVERIFY(std::abs(glm::length(turned) - 10) < 1e-12);
        QVERIFY(std::abs(degreesOf(turned) - 30) < 1e-12);
        QVERIFY(std::abs(map.scale() - 1) < 1e-15);
    }
    void skewLeansToTheRight()
    {
        QVERIFY(near(horizontalSkew(45, {0, 10})(Point(5, 0)), {15, 0}));
        QVERIFY(near(verticalSkew(45, {10, 0})(Point(20, 5)), {20, -5}));
        QCOMPARE(horizontalSkew(20, {}).scale(), 1);
    }
    void placementIsGivenWhereNothingTurns()
    {
        const auto where = scaling({2, -1}, {3, 5}).placement();
        QVERIFY(where);
        QCOMPARE((*where)(Point(4, 6)), Point(5, 4));
        QVERIFY(!rotation(10, {}).placement() && !horizontalSkew(1, {}).placement());
        QVERIFY(rotation(360, {}).placement());
    }
    void mapsWithoutNumbersAreNotFinite()
    {
        QVERIFY(rotation(10, {1, 2}).isFinite());
        QVERIFY(!scaling({std::numeric_limits<double>::quiet_NaN(), 1}, {}).isFinite());
        QVERIFY(!translation({0, std::numeric_limits<double>::infinity()}).isFinite());
    }
    void shapesStayShapesWhereTheirKindAllowsIt()
    {
        const Recipe box = RectangleRecipe{{1, 2}, {10, 20}, 3},
                     oval = EllipseRecipe{{1, 2}, {3, 4}}, circle = EllipseRecipe{{1, 2}, {3, 3}},
                     star = StarRecipe{{1, 2}, 6, 3, 0.5, 7},
                     text = TextRecipe{"Text", "Sans", 12, {1, 2}};
        const AffineMap quarter = rotation(90, {0, 0}), some = rotation(20, {0, 0});
        QVERIFY(mapped(box, quarter) == Recipe(RectangleRecipe{{2, -11}, {20, 10}, 3}));
        QVERIFY(mapped(oval, quarter) == Recipe(EllipseRecipe{{2, -1}, {4, 3}}));
        QVERIFY(mapped(circle, some).index() == circle.index());
        const Recipe drawn = EllipseRecipe{{1, 2}, {53.3 - 50, (13.3 - 6.7) / 2}}; // rounded
        QVERIFY(mapped(drawn, some).index() == drawn.index());
        QVERIFY(mapped(star, some).index() == star.index());
        for (const Recipe& kept : {box, oval})
            QVERIFY(mapped(kept, some).index() == kept.index());
        for (const Recipe& lost : {box, oval, circle, star, text})
            QVERIFY(mapped(lost, horizontalSkew(20, {})).index() == 0);
        const auto turned = std::get<StarRecipe>(mapped(star, rotation(30, {1, 2})));
        QVERIFY(std::abs(turned.turn - (0.5 - glm::radians(30.0))) < 1e-12);
        QVERIFY(near(turned.centre, {1, 2}) && std::abs(turned.outer - 6) < 1e-12);
        const auto words = std::get<TextRecipe>(mapped(text, rotation(30, {1, 2})));
        QVERIFY(std::abs(words.turn + glm::radians(30.0)) < 1e-12 && !words.mirrored);
        QVERIFY(near(words.at, {1, 2}) && std::abs(words.size - 12) < 1e-12);
    }
};

} // namespace document_affine_map_test

TEST_CLASS(document_affine_map_test::AffineMapTest, None)
#include "tests/app/document/affine_map_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recipe.h"
#include "app/document/recipe_outline.h"

#include <QTest>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <numbers>
#include <vector>

#include "tests/test_class.h"

namespace document_recipe_test {

using namespace app;

namespace {

const std::vector<Recipe> all{
    RectangleRecipe{{1, 2}, {10, 20}},      RectangleRecipe{{1, 2}, {10, 20}, 3},
    EllipseRecipe{{1, 2}, {3, 4}},          StarRecipe{{1, 2}, 6, 3, 0.5, 7},
    TextRecipe{"Text", "Sans", 12, {1, 2}},
};
const Placement move{{1, 1}, {5, -7}}, twice{{2, 2}, {0, 1}}, wide{{3, 1}, {0, 0}};
const Placement mirror{{-1, 1}, {10, 0}}, upsideDown{{1, -1}, {0, 3}}, flat{{1, 0}, {0, 0}};

std::vector<bool> kept(const Placement& where)
{
    std::vector<bool> kept;
    for (const Recipe& recipe : all)
        kept.push_back(placed(recipe, where).index() == recipe.index());
    return kept;
}

Point firstPoint(const StarRecipe& star)
{
    return star.centre + star.outer * Point(std::cos(star.turn), std::sin(star.turn));
}

AffineMap mapOf(const Placement& where)
{
    return {{where.scale.x, 0}, {0, where.scale.y}, Point(0), where(Point(0))};
}

/// Whether the outline of `after` runs through the points of the mapped outline of `before`, in
/// whatever order.
bool samePoints(const Recipe& after, const Recipe& before, const AffineMap& map)
{
    const Subpath there = *outlineOf(after), here = *outlineOf(before);
    std::vector<Point> points;
    forEachPoint(there, [&](const Point& p) { points.push_back(p); });
    bool same = after.index() == before.index();
    forEachPoint(here, [&](const Point& p) {
        same = same && std::ranges::any_of(points, [&](const Point& q) {
                   return glm::distance(map(p), q) < 1e-12 * 100;
               });
    });
    return same;
}

bool sameNumbers(const Recipe& a, const Recipe& b)
{
    const auto path = outlineOf(a);
    return a.index() == b.index() && makes(b, std::span(&*path, 1));
}

} // namespace

class RecipeTest : public QObject {
    Q_OBJECT

private slots:
    void itStaysWhereThePathIsStillMadeByIt()
    {
        QCOMPARE(kept(Placement{}), (std::vector{true, true, true, true, true}));
        QCOMPARE(kept(move), (std::vector{true, true, true, true, true}));
        QCOMPARE(kept(twice), (std::vector{true, true, true, true, true}));
        QCOMPARE(kept(wide), (std::vector{true, false, true, false, false}));
        QCOMPARE(kept(mirror), (std::vector{true, true, true, true, true}));
        QCOMPARE(kept(upsideDown), (std::vector{true, true, true, true, true}));
        QCOMPARE(kept(flat), (std::vector{false, false, false, false, false}));
        QVERIFY(placed(Recipe{}, twice) == Recipe{});
        QVERIFY(placed(all[0], wide.then(flat)) == Recipe{});
    }
    void itsNumbersArePlaced()
    {
        QVERIFY(placed(all[1], twice) == Recipe(RectangleRecipe{{2, 5}, {20, 40}, 6}));
        QVERIFY(placed(all[1], mirror) == Recipe(RectangleRecipe{{-1, 2}, {10, 20}, 3}));
        QVERIFY(placed(all[0], wide) == Recipe(RectangleRecipe{{3, 2}, {30, 20}}));
        QVERIFY(placed(all[2], wide) == Recipe(EllipseRecipe{{3, 2}, {9, 4}}));
        QVERIFY(placed(all[2], upsideDown) == Recipe(EllipseRecipe{{1, 1}, {3, 4}}));
        QVERIFY(placed(all[4], twice) == Recipe(TextRecipe{"Text", "Sans", 24, {2, 5}}));
    }
    void aMirroredTextKnowsIt()
    {
        const auto below = std::get<TextRecipe>(placed(all[4], upsideDown));
        QVERIFY(below.mirrored && below.turn == 0 && below.at == Point(1, 1) && below.size == 12);
        const auto turned = std::get<TextRecipe>(placed(below, mirror));
        QVERIFY(!turned.mirrored && std::abs(turned.turn) == std::numbers::pi);
        QVERIFY(placed(turned, move)
                == Recipe(TextRecipe{"Text", "Sans", 12, {14, -6}, turned.turn}));
    }
    // Whatever a map makes of the recipe, its outline has the points of the mapped one.
    void aTurnedShapeKeepsItsSidesAndItsTurn()
    {
        const Point about(5, -3);
        for (const Recipe& recipe : {all[0], all[1], all[2]}) {
            const Recipe turned = mapped(recipe, rotation(-30, about)); // clockwise on screen
            QCOMPARE(turned.index(), recipe.index());
            QVERIFY(samePoints(turned, recipe, rotation(-30, about)));
            QVERIFY(samePoints(placed(turned, twice), turned, mapOf(twice)));
            QVERIFY(samePoints(placed(turned, mirror), turned, mapOf(mirror)));
            QVERIFY(samePoints(placed(turned, move), turned, mapOf(move)));
            QCOMPARE(placed(turned, wide).index(), 0u); // no right angles are left
            QCOMPARE(mapped(turned, horizontalSkew(10, about)).index(), 0u);
            QVERIFY(sameNumbers(mapped(turned, rotation(30, about)), recipe));
            QVERIFY(samePoints(mapped(turned, rotation(-60, about)), recipe, rotation(-90, about)));
        }
        const auto turned = std::get<RectangleRecipe>(mapped(all[0], rotation(-30, about)));
        QVERIFY(std::abs(turned.turn - std::numbers::pi / 6) < 1e-12);
        QVERIFY(glm::distance(turned.size, Point(10, 20)) < 1e-12);
        const auto quarter = std::get<RectangleRecipe>(mapped(turned, rotation(-60, about)));
        QCOMPARE(quarter.turn, 0);
        QVERIFY(glm::distance(quarter.size, Point(20, 10)) < 1e-12);
    }
    void aStarTurnsWithItsFirstPoint()
    {
        const StarRecipe star = std::get<StarRecipe>(all[3]);
        for (const Placement& where : {move, twice, mirror, upsideDown, mirror.then(upsideDown)}) {
            const Point there = firstPoint(std::get<StarRecipe>(placed(star, where)));
            const Point expected = where(firstPoint(star));
            QVERIFY(std::abs(there.x - expected.x) < 1e-12
                    && std::abs(there.y - expected.y) < 1e-12);
        }
    }
};

} // namespace document_recipe_test

TEST_CLASS(document_recipe_test::RecipeTest, None)
#include "tests/app/document/recipe_test.moc"

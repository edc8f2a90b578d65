// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recipe.h"

#include <QTest>

#include <glm/trigonometric.hpp>

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

// SPDX-License-Identifier: GPL-3.0-or-later
// Clip windows of all shapes, moved, resized and rotated.
#include "app/document/document_builder.h"
#include "app/document/recipe_outline.h"
#include "app/document/window_outline.h"
#include "app/document/window_shape.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/test_class.h"

namespace document_window_shape_test {

using namespace app;

namespace {

constexpr double pi = std::numbers::pi;

bool near(const Point& a, const Point& b) { return glm::distance(a, b) < 1e-9; }

bool near(const clipping::Window& a, const clipping::Window& b)
{
    return near(a.min, b.min) && near(a.max, b.max);
}

PathShape made(const Recipe& recipe)
{
    const auto outline = outlineOf(recipe);
    return {Path({&*outline, 1}), FillRule::EvenOdd, recipe};
}

} // namespace

class WindowShapeTest : public QObject {
    Q_OBJECT

private slots:
    void anAxisAlignedRectangleStaysSoBitForBit()
    {
        const RectangleShape old{{{1, 2}, {4, 6}}};
        QVERIFY(mapped(old, translation({0.5, -1}))
                == WindowShape(RectangleShape{{{1.5, 1}, {4.5, 5}}}));
        QVERIFY(mapped(old, scaling({-1, 2}, {0, 0}))
                == WindowShape(RectangleShape{{{-4, 4}, {-1, 12}}}));
    }
    void aRotatedRectangleKeepsItsSizeAndItsCentre()
    {
        const WindowShape old = RectangleShape{{{10, 20}, {16, 28}}, 0.25};
        const auto turned = std::get<RectangleShape>(mapped(old, rotation(-30, {13, 24})));
        QVERIFY(near(turned.box, {{10, 20}, {16, 28}}));
        QVERIFY(std::abs(turned.angle - 0.25 - pi / 6) < 1e-12);
        const auto moved = std::get<RectangleShape>(mapped(old, translation({5, 7})));
        QVERIFY(near(moved.box, {{15, 27}, {21, 35}}) && moved.angle == 0.25);
    }
    void quarterTurnsLeaveARectangleAxisAligned()
    {
        const WindowShape old = RectangleShape{{{10, 20}, {16, 28}}};
        QVERIFY(rotated(old, pi / 2) == WindowShape(RectangleShape{{{9, 21}, {17, 27}}}));
        QVERIFY(rotated(old, -pi) == old);
        QVERIFY(std::get<RectangleShape>(rotated(old, 0.1)).angle == 0.1);
    }
    void degeneratePathsStayWhatTheyAre()
    {
        QVERIFY(isEmpty(PathShape{}) && !isEmpty(RectangleShape{}));
        QVERIFY(boxOf(PathShape{}) == clipping::Window{});
        const Subpath ring{{0, 0}, {{{4, 0}}, {{0, 2}}}, true};
        const WindowShape triangle = PathShape{Path({&ring, 1})};
        QVERIFY(fitted(triangle, {{{1, 1}, {1, 9}}})
                == triangle); // it could never be widened again
    }
    void aSkewedRectangleBecomesAPath()
    {
        const WindowShape skewed =
            mapped(RectangleShape{{{0, 0}, {2, 2}}}, horizontalSkew(45, {0, 0}));
        const auto ring = outlineOf(skewed, 1).rings.at(0);
        QCOMPARE(ring.size(), 4u);
        for (const auto& [corner, place] :
             {std::pair(0, Point(0, 0)), {1, {2, 0}}, {2, {0, 2}}, {3, {-2, 2}}})
            QVERIFY(near(ring[std::size_t(corner)], place));
        QVERIFY(std::holds_alternative<PathShape>(
            mapped(RectangleShape{{{0, 0}, {2, 1}}, 0.3}, scaling({2, 1}, {0, 0}))));
    }
    void aTurnedRectangleIsAWindowWithItsCorners()
    {
        Recipe recipe = RectangleRecipe{{10.1, 20}, {30, 7.3}};
        Path path = made(recipe).path;
        transform(path, recipe, rotation(23, {1, 2}));
        DocumentBuilder builder;
        builder.open({.name = "Drawing"});
        builder.add(Object{.path = path, .style = {}, .particulars = {.recipe = recipe}});
        builder.close();
        const Document document = builder.take({});
        const auto window = windowOf(document.objects()[0]);
        QVERIFY(std::get<RectangleShape>(window->shape).angle != 0);
        const PathShape back = pathOf(window->shape);
        QVERIFY(back.path == path);
        QVERIFY(makes(back.recipe, path.subpaths()));
    }
    void anEllipseThatIsTurnedHasItsEdgesOnIt()
    {
        const auto oval =
            std::get<PathShape>(mapped(made(EllipseRecipe{{5, 5}, {6, 3}}), rotation(40, {0, 0})));
        const auto& recipe = std::get<EllipseRecipe>(oval.recipe);
        QVERIFY(makes(recipe, oval.path.subpaths()));
        const auto ring = outlineOf(oval, 0.01).rings.at(0);
        for (const Point& corner : ring)
            QVERIFY(
                std::abs(glm::length(turnedBy(corner - recipe.centre, -recipe.turn) / recipe.radii)
                         - 1)
                < 1e-12);
        const auto drawn = drawnOutlineOf(oval, 0.001).rings.at(0);
        const auto box = boxOf(oval);
        for (const auto& points : {ring, drawn})
            for (const int axis : {0, 1}) {
                const auto [least, most] =
                    std::ranges::minmax(points, {}, [&](const Point& p) { return p[axis]; });
                QVERIFY(std::abs(least[axis] - box.min[axis]) < 0.02);
                QVERIFY(std::abs(most[axis] - box.max[axis]) < 0.02);
            }
    }
    void aCircleStaysACircle()
    {
        const WindowShape circle = made(EllipseRecipe{{5, 5}, {3, 3}});
        const auto turned = std::get<PathShape>(mapped(circle, rotation(40, {0, 0})));
        QVERIFY(std::holds_alternative<EllipseRecipe>(turned.recipe));
        QCOMPARE(turned.rule, FillRule::EvenOdd);
        QVERIFY(makes(turned.recipe, turned.path.subpaths()));
    }
    void boxes()
    {
        QVERIFY(near(boxOf(RectangleShape{{{0, 0}, {4, 2}}, pi / 2}), {{1, -1}, {3, 3}}));
        const auto box = boxOf(made(EllipseRecipe{{5, 5}, {3, 2}}));
        QVERIFY(glm::distance(box.min, {2, 3}) < 1e-3 && glm::distance(box.max, {8, 7}) < 1e-3);
    }
    void aHandleOfARotatedFrameLeavesTheOppositeCornerWhereItIs()
    {
        const WindowFrame frame{{{10, 20}, {16, 28}}, 0.4};
        clipping::Window box = frame.box;
        box.max += Point(5, -3); // the corner at the lower right was dragged
        const WindowFrame after = resized(frame, box);
        QVERIFY(near(cornersOf(after)[0], cornersOf(frame)[0]));
        QVERIFY(near(after.box.max - after.box.min, {11, 5}));
        QCOMPARE(after.angle, 0.4);
        QVERIFY(fitted(frame, after) == WindowShape(after));
    }
    void framesAndBack()
    {
        const WindowFrame frame{{{10, 20}, {16, 28}}, 0.4};
        const Point p(3, 9);
        QVERIFY(near(outOfFrame(frame, intoFrame(frame, p)), p));
        for (int i = 0; i < 4; ++i)
            QVERIFY(near(intoFrame(frame, cornersOf(frame)[std::size_t(i)]),
                         cornersOf({frame.box})[std::size_t(i)]));
    }
    void aPathIsResizedByItsBox()
    {
        const WindowShape triangle = [] {
            const Subpath ring{{0, 0}, {{{4, 0}}, {{0, 2}}}, true};
            return PathShape{Path({&ring, 1})};
        }();
        const WindowFrame from = frameOf(triangle);
        QVERIFY(near(from.box, {{0, 0}, {4, 2}}));
        const auto after = fitted(triangle, {{{1, 1}, {3, 9}}});
        QVERIFY(near(boxOf(after), {{1, 1}, {3, 9}}));
    }
    void flatShapesAreOnlyMoved()
    {
        const Subpath line{{1, 1}, {{{1, 5}}}, true};
        const WindowShape flat = PathShape{Path({&line, 1})};
        const auto after = fitted(flat, {{{3, 1}, {9, 3}}});
        QVERIFY(near(boxOf(after), {{3, 1}, {3, 3}}));
    }
};

} // namespace document_window_shape_test

TEST_CLASS(document_window_shape_test::WindowShapeTest, None)
#include "tests/app/document/window_shape_test.moc"

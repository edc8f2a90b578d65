// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/history.h"
#include "app/commands/transform_objects.h"
#include "app/document/document_builder.h"
#include "app/document/recipe_outline.h"

#include <QTest>

#include <glm/geometric.hpp>

#include "tests/test_class.h"

namespace commands_transform_objects_test {

using namespace app;

class TransformObjectsTest : public QObject {
    Q_OBJECT

    static Object made(std::vector<Subpath> paths, Recipe recipe = {})
    {
        Object object{.path = Path(paths), .style = {.stroke = Colour{}, .width = 2}};
        object.style.dashes = {3, 1};
        object.particulars.recipe = std::move(recipe);
        return object;
    }
    static Object shape(const Recipe& recipe) { return made({*outlineOf(recipe)}, recipe); }
    static Document drawing(std::vector<Object> objects)
    {
        DocumentBuilder builder;
        builder.open({.name = "Drawing"});
        for (Object& object : objects)
            builder.add(std::move(object));
        builder.close();
        return builder.take({});
    }
    static bool near(const Point& a, const Point& b) { return glm::distance(a, b) < 1e-9; }

private slots:
    void everyPointIsMapped()
    {
        const Subpath curve{{0, 0}, {{{30, 0}, {10, 5}, {20, 5}, true}, {{30, 10}}}, false};
        EditedDocument document(drawing({made({curve}), made({{{1, 1}, {{{5, 1}}}, false}})}));
        History history;
        const Document before = document.now();
        const AffineMap map = rotation(90, {0, 0});
        history.push(
            new TransformObjects(document, ObjectRanges{0, 1}, map, StrokeScaling::Keep, "Rotate"));
        const Subpath turned = document.now().objects()[0].path().subpaths().front();
        QCOMPARE(turned.segments[0].control1, Point(5, -10));
        QCOMPARE(turned.segments[0].to, Point(0, -30));
        QCOMPARE(turned.segments[1].to, Point(10, -30));
        QCOMPARE(document.now().objects()[1].path().singleLine()->b, Point(1, -5));
        history.undo();
        QVERIFY(document.now() == before);
    }
    void rectanglesAndCirclesStayShapes()
    {
        EditedDocument document(drawing(
            {shape(RectangleRecipe{{10, 20}, {30, 5}}), shape(EllipseRecipe{{0, 0}, {4, 4}})}));
        History history;
        history.push(new TransformObjects(document, ObjectRanges{0, 1}, rotation(90, {0, 0}),
                                          StrokeScaling::Keep, "Rotate"));
        for (const std::size_t i : {0, 1}) {
            const Object object = document.now().objects()[i].copy();
            QVERIFY(object.particulars.recipe.index() != 0);
            QVERIFY(makes(object.particulars.recipe, object.path.subpaths()));
        }
        for (const AffineMap& map : {rotation(180, {3, 4}), scaling({-1, 1}, {3, 4})}) {
            history.push(new TransformObjects(document, ObjectRanges{0, 1}, map,
                                              StrokeScaling::Keep, "Turn"));
            for (const std::size_t i : {0, 1}) {
                const Object object = document.now().objects()[i].copy();
                QVERIFY(makes(object.particulars.recipe, object.path.subpaths()));
            }
            history.undo();
        }
        const auto box =
            std::get<RectangleRecipe>(document.now().objects()[0].copy().particulars.recipe);
        QVERIFY(near(box.corner, {20, -40}) && near(box.size, {5, 30}));
        history.push(new TransformObjects(document, ObjectRanges{0, 1}, rotation(10, {0, 0}),
                                          StrokeScaling::Keep, "Rotate"));
        for (const std::size_t i : {0, 1}) {
            const Object object = document.now().objects()[i].copy();
            QVERIFY(makes(object.particulars.recipe, object.path.subpaths()));
        }
        const auto turned =
            std::get<RectangleRecipe>(document.now().objects()[0].copy().particulars.recipe);
        QVERIFY(near(turned.size, {5, 30}) && turned.turn != 0);
    }
    void copiesAreAddedForEachMap()
    {
        Object original = made({{{0, 0}, {{{10, 0}}}, false}});
        original.particulars.id = "a";
        EditedDocument document(drawing({original, made({{{7, 7}, {{{8, 8}}}, false}})}));
        History history;
        const std::vector maps{translation({0, 5}), rotation(90, {0, 0})};
        history.push(
            new CopyObjects(document, copying(document.now(), ObjectRanges{0}, maps), "Copy"));
        const Objects& all = document.now().objects();
        QCOMPARE(all.size(), std::size_t(4));
        QVERIFY(all[0].copy() == original);
        QCOMPARE(all[2].singleLine()->b, Point(10, 5));
        QCOMPARE(all[3].singleLine()->b, Point(0, -10));
        QVERIFY(all[2].particulars().id.isEmpty());
        history.undo();
        QCOMPARE(document.now().objects().size(), std::size_t(2));
    }
    void strokesScaleOnlyByChoice()
    {
        EditedDocument document(drawing({made({{{0, 0}, {{{10, 0}}}, false}})}));
        History history;
        const AffineMap map = scaling({4, 9}, {0, 0});
        const auto style = [&] { return document.now().objects()[0].copy().style; };
        history.push(
            new TransformObjects(document, ObjectRanges{0}, map, StrokeScaling::Keep, "Scale"));
        QCOMPARE(style().width, 2);
        history.push(
            new TransformObjects(document, ObjectRanges{0}, map, StrokeScaling::Scale, "Scale"));
        QCOMPARE(style().width, 12); // the mean factor is 6
        QCOMPARE(style().dashes, (std::vector<double>{18, 6}));
    }
};

} // namespace commands_transform_objects_test

TEST_CLASS(commands_transform_objects_test::TransformObjectsTest, None)
#include "tests/app/commands/transform_objects_test.moc"

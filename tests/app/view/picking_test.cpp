// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/picking.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <random>

#include "tests/app/document/sheet_edits.h"

namespace {

app::Shape line(app::Point a, app::Point b)
{
    app::Shape shape;
    shape.paths.push_back({a, {{b}}, false});
    return shape;
}

app::Sheet randomSheet(std::mt19937_64& random, std::size_t count)
{
    std::uniform_real_distribution<double> place(-100, 100), step(-20, 20);
    app::Sheet sheet;
    for (std::size_t i = 0; i < count; ++i) {
        const app::Point a(place(random), place(random));
        switch (i % 4) {
        case 0:
            sheet.shapes.push_back(line(a, a + app::Point(step(random), 0)));
            break;
        case 1:
            sheet.shapes.push_back(line(a, a + app::Point(0, step(random))));
            break;
        case 2:
            sheet.shapes.push_back(line(a, {place(random), place(random)}));
            break;
        default:
            sheet.shapes.push_back(line(a, a));
            break;
        }
    }
    return sheet;
}

} // namespace

class PickingTest : public QObject {
    Q_OBJECT

private slots:
    void nearFindsWhatLookingAtAllFinds()
    {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> place(-130, 130), radius(0, 15);
        app::EditedDocument document(app::documentOf(randomSheet(random, 500)));
        const app::Scene scene(document);
        const app::Picking picking(document, scene);
        for (int round = 0; round < 300; ++round) {
            if (round % 50 == 49)
                ::splice(document, round, 3, {line({place(random), 0}, {0, place(random)})});
            const app::Point p(place(random), place(random));
            const double r = radius(random);
            std::vector<std::size_t> all;
            for (std::size_t i = 0; i < scene.segments().size(); ++i)
                if (app::distance(p, scene.segments()[i]) <= r)
                    all.push_back(i);
            QCOMPARE(picking.near(p, r), all);
        }
    }
    void distanceIsToTheSegmentNotItsLine()
    {
        QCOMPARE(app::distance({0, 3}, {{-1, 0}, {1, 0}}), 3.0);
        QCOMPARE(app::distance({4, 4}, {{-1, 0}, {1, 0}}), 5.0);
        QCOMPARE(app::distance({3, 4}, {{0, 0}, {0, 0}}), 5.0);
    }
    void theUppermostOfTwoIsPickedAndLockedOnesAreNot()
    {
        app::Sheet sheet;
        sheet.layers = {{"below"}, {"above"}};
        sheet.shapes = {line({0, 0}, {10, 0}), line({0, 0}, {10, 0})};
        sheet.shapes[1].layer = 1;
        app::EditedDocument document(app::documentOf(sheet));
        const app::Scene scene(document);
        const app::Picking picking(document, scene);
        QCOMPARE(picking.nearest({5, 1}, 2), std::optional<std::size_t>(1));
        ::setLayers(document, {{"below"}, {"above", true, true}});
        QCOMPARE(picking.nearest({5, 1}, 2), std::optional<std::size_t>(0));
        ::setLayers(document, {{"below", false}, {"above", true, true}});
        QCOMPARE(picking.nearest({5, 1}, 2), std::nullopt);
    }
    void areasArePickedByTheirRule()
    {
        app::Sheet sheet;
        app::Shape rings; // two squares, turning the same way
        for (const double r : {10.0, 5.0})
            rings.paths.push_back({{-r, -r}, {{{r, -r}}, {{r, r}}, {{-r, r}}}, true});
        rings.style.fill = app::Colour{};
        sheet.shapes = {rings, rings};
        sheet.shapes[1].style.fillRule = app::FillRule::EvenOdd;
        app::EditedDocument document(app::documentOf(sheet));
        const app::Scene scene(document);
        const app::Picking picking(document, scene);
        QCOMPARE(picking.areaAt({7, 0}), std::optional<std::size_t>(1));
        QCOMPARE(picking.areaAt({0, 0}), std::optional<std::size_t>(0)); // through the hole
        QCOMPARE(picking.areaAt({12, 0}), std::nullopt);
    }
    void aBoxContainsOrTouches()
    {
        app::Sheet sheet;
        sheet.shapes = {line({1, 1}, {2, 2}), line({1, 1}, {20, 1}), line({20, 20}, {30, 30}),
                        line({-5, 4}, {15, 4})};
        app::EditedDocument document(app::documentOf(sheet));
        const app::Scene scene(document);
        const app::Picking picking(document, scene);
        using Set = app::ObjectRanges;
        QCOMPARE(picking.shapesIn({{0, 0}, {10, 10}}, app::Picking::Box::Contains), Set{0});
        QCOMPARE(picking.shapesIn({{0, 0}, {10, 10}}, app::Picking::Box::Touches), (Set{0, 1, 3}));
    }
};

QTEST_APPLESS_MAIN(PickingTest)
#include "picking_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/cut.h"
#include "app/document/document_builder.h"
#include "app/scene/scene_clipping.h"
#include "app/scene/scene_lines.h"
#include "app/view/picture.h"
#include "app/view/raster.h"
#include "app/view/visible_colour.h"

#include <QTest>

#include <cmath>

#include "tests/app/view/compare_images.h"
#include "tests/app/view/joined.h"
#include "tests/test_class.h"

namespace view_picture_test {

namespace {

app::Subpath square(app::Point min, double side)
{
    return {min, {{{min.x + side, min.y}}, {min + side}, {{min.x, min.y + side}}}, true};
}

app::Object object(const app::Subpath& path, const app::Style& style)
{
    return {app::Path(std::vector{path}), style};
}

app::Object filledSquare(app::Point min, double side)
{
    return object(square(min, side), {.stroke = app::Colour{}, .fill = app::Colour{200, 0, 0}});
}

// One pixel to the unit, 100 x 100, the window the left half.
struct Stage {
    explicit Stage(const std::vector<app::Object>& objects)
    {
        app::DocumentBuilder builder;
        builder.open({.name = "layer"});
        for (const app::Object& object : objects)
            builder.add(object);
        builder.close();
        document = builder.take({{0, 0}, {100, 100}, {100, app::Unit::Px}, {100, app::Unit::Px}});
        lines = app::linesOf(document);
        options.view.size = {100, 100};
        options.view.centre = {50, 50};
    }
    app::Picture picture()
    {
        const app::ClipRegion region{{{window, app::WindowOperation::Add}}, keep};
        const app::SceneFrame frame =
            clips.clip(lines, region, clipping::exactAlgorithm().corrected.clipAll);
        options.region = &region;
        return app::picture(document.styles(), lines, frame, options);
    }
    QImage image() { return app::rasterised(picture(), {0, 100}, {100, 1, 0.32}); }

    app::Document document;
    app::SceneLines lines;
    app::SceneClipping clips;
    clipping::Window window{{0, 0}, {50, 100}};
    app::Keep keep = app::Keep::Inside;
    app::PictureOptions options;
};

std::size_t fillsIn(const app::DrawList& drawList)
{
    return std::size_t(std::ranges::count_if(drawList.commands,
                                             [](const auto& command) { return !command.stroke; }));
}

} // namespace

class PictureTest : public QObject {
    Q_OBJECT

private slots:
    void areasAreCutAtTheWindow()
    {
        Stage stage(
            {filledSquare({10, 10}, 20), filledSquare({40, 10}, 20), filledSquare({70, 10}, 20)});
        const app::Picture picture = stage.picture();
        QCOMPARE(fillsIn(picture.kept), std::size_t(2));
        QCOMPARE(fillsIn(picture.ghost), std::size_t(2));
        const QImage image = stage.image();
        QCOMPARE(image.pixelColor(20, 20), QColor(200, 0, 0));
        QCOMPARE(image.pixelColor(45, 20), QColor(200, 0, 0));
        for (const int x : {55, 80})
            QVERIFY(std::abs(image.pixelColor(x, 20).alpha() - 0.32 * 255) < 2);
    }
    // None of its lines is kept, or all of them are.
    void anAreaAroundTheWindowIsCut()
    {
        for (const bool inside : {true, false}) {
            Stage stage({filledSquare({-20, -20}, 140)});
            stage.window = {{30, 30}, {60, 60}};
            stage.keep = inside ? app::Keep::Inside : app::Keep::Outside;
            stage.options.removed = app::RemovedPart::Hidden;
            const QImage image = stage.image();
            QCOMPARE(image.pixelColor(45, 45).alpha(), inside ? 255 : 0);
            QCOMPARE(image.pixelColor(80, 45).alpha(), inside ? 0 : 255);
        }
    }
    // What is seen is what a cut leaves, with a stroke along the cut and without.
    void aPictureShowsWhatACutLeaves_data()
    {
        QTest::addColumn<bool>("closed");
        QTest::addColumn<bool>("outside");
        for (const bool closed : {false, true})
            for (const bool outside : {false, true})
                QTest::addRow("%d %d", closed, outside) << closed << outside;
    }
    void aPictureShowsWhatACutLeaves()
    {
        QFETCH(bool, closed);
        QFETCH(bool, outside);
        app::Style dashed{.stroke = app::Colour{0, 0, 200}, .fill = app::Colour{200, 200, 0}};
        dashed.width = 3;
        app::Object curved =
            object({{10, 60}, {{{90, 60}, {30, 20}, {70, 99}, true}, {{60, 95}}}, true}, dashed);
        dashed.dashes = {5, 3};
        Stage stage({filledSquare({40, 10}, 20), filledSquare({-20, 30}, 140), std::move(curved),
                     object(square({20, 40}, 50), dashed),
                     object(square({35, 45}, 30), {.stroke = app::Colour{}})});
        stage.options.removed = app::RemovedPart::Hidden;
        stage.options.closesAreas = closed;
        stage.keep = outside ? app::Keep::Outside : app::Keep::Inside;
        const QImage seen = stage.image();
        app::CutOptions options{clipping::exactAlgorithm().corrected.clipAll};
        options.region = {{{stage.window, app::WindowOperation::Add}}, stage.keep};
        options.closeAreas = closed;
        stage.document.apply(app::cut(stage.document, options).edit);
        stage.lines = app::linesOf(stage.document);
        stage.window = {{-999, -999}, {999, 999}};
        stage.keep = app::Keep::Inside;
        QVERIFY2(shareBeyond(seen, stage.image(), 8) < 1e-3,
                 qPrintable(QString::number(shareBeyond(seen, stage.image(), 8))));
        // Half a pixel of stroke on either side of the cut.
        QCOMPARE(seen.pixelColor(outside ? 50 : 49, 35).red() < 150, closed);
    }
    void theRemovedPartIsHiddenOrShown()
    {
        Stage stage({filledSquare({40, 10}, 20), filledSquare({70, 10}, 20)});
        stage.options.removed = app::RemovedPart::Hidden;
        QCOMPARE(stage.image().pixelColor(80, 20).alpha(), 0);
        stage.options.removed = app::RemovedPart::Shown;
        QCOMPARE(stage.image().pixelColor(80, 20), QColor(200, 0, 0));
        QCOMPARE(stage.image().pixelColor(45, 20), QColor(200, 0, 0));
    }
    void aProjectorGetsWiderStrokesAndGhostsThatCanBeSeen()
    {
        Stage stage({filledSquare({40, 10}, 20)});
        const double width = stage.picture().kept.commands.front().stroke->width;
        stage.options.strokes = 2;
        stage.options.ghosting = app::Ghosting{{255, 255, 255}, 0.32};
        const app::Picture picture = stage.picture();
        QCOMPARE(picture.kept.commands.front().stroke->width, 2 * width);
        QVERIFY(app::contrast(picture.ghost.commands.front().stroke->colour, {255, 255, 255}) >= 3);
    }
    void theOutsideCanBeKept()
    {
        Stage stage({filledSquare({10, 10}, 20), filledSquare({70, 10}, 20)});
        stage.keep = app::Keep::Outside;
        QCOMPARE(stage.image().pixelColor(80, 20), QColor(200, 0, 0));
        QVERIFY(std::abs(stage.image().pixelColor(20, 20).alpha() - 0.32 * 255) < 2);
    }
    void anAreaWithoutStrokeHasNoneWhenCut()
    {
        app::Object area = filledSquare({40, 10}, 20);
        area.style.stroke.reset();
        Stage stage({area});
        const app::Picture picture = stage.picture();
        QCOMPARE(picture.kept.commands.size(), std::size_t(1));
        QVERIFY(!picture.kept.commands[0].stroke);
        QCOMPARE(picture.kept.commands[0].fill, (app::Colour{200, 0, 0}));
    }
    void oneStrokeIsOnePolylineAndCutEndsAreButt()
    {
        Stage stage({object({{10, 10}, {{{30, 12}}, {{30, 40}}, {{80, 40}}}, false},
                            {.stroke = app::Colour{}, .cap = app::Cap::Round})});
        const app::Picture picture = stage.picture();
        QCOMPARE(picture.kept.polylines.size(), std::size_t(1));
        QCOMPARE(picture.kept.polylines[0].count, 4U);
        QVERIFY(picture.kept.polylines[0].capAtStart && !picture.kept.polylines[0].capAtEnd);
        QCOMPARE(picture.ghost.polylines.size(), std::size_t(1));
        QVERIFY(!picture.ghost.polylines[0].capAtStart && picture.ghost.polylines[0].capAtEnd);
        QCOMPARE(picture.kept.points.back(), QPointF(50, 40));
    }
    void cutDashesKeepTheirCaps()
    {
        Stage stage({object(
            {{10, 10}, {{{80, 10}}}, false},
            {.stroke = app::Colour{}, .width = 2, .dashes = {0, 4}, .cap = app::Cap::Round})});
        const app::Picture picture = stage.picture();
        QVERIFY(picture.kept.polylines.size() >= 10);
        for (const app::Polyline& dot : picture.kept.polylines)
            QVERIFY(dot.capAtStart && dot.capAtEnd);
    }
    void deepZoomHandsOutNoHugeNumbers()
    {
        Stage stage({filledSquare({-1e6, -1e6}, 2.1e6), filledSquare({10, 10}, 20)});
        stage.window = {{-2e6, -2e6}, {2e6, 2e6}};
        stage.options.view.zoom = 1e7;
        stage.options.view.centre = {10, 10};
        const app::Picture picture = stage.picture();
        QVERIFY(!picture.kept.points.empty());
        for (const QPointF& p : picture.kept.points)
            QVERIFY2(std::abs(p.x()) < 1e9 && std::abs(p.y()) < 1e9,
                     qPrintable(QString::number(p.x())));
        QCOMPARE(stage.image().pixelColor(90, 90),
                 QColor(0, 0, 0)); // the stroke is far wider than the view
    }
    void dashesGoOnThroughTheWindow()
    {
        Stage stage({object({{5, 50}, {{{95, 50}}}, false},
                            {.stroke = app::Colour{}, .width = 2, .dashes = {10, 10}})});
        const QImage image = stage.image();
        for (int x = 6; x < 94; ++x)
            if ((x - 5) % 10 != 0 && (x - 5) % 10 != 9 && std::abs(x - 50) > 1)
                QCOMPARE(image.pixelColor(x, 50).alpha() > 0, (x - 5) % 20 < 10);
    }
    void aSelectedObjectKeepsItsColourOnABandWithAnOutline()
    {
        Stage stage({filledSquare({40, 10}, 20)});
        const app::ObjectRanges selected{0};
        const QImage before = stage.image();
        stage.options.selection = selected.ranges();
        stage.options.light = {0, 0, 255};
        const app::Picture picture = stage.picture();
        QCOMPARE(picture.selected.polylines.size(), std::size_t(2)); // whole, also outside
        QCOMPARE(picture.selected.polylines[0].count, 5U);
        const QImage image = stage.image();
        QCOMPARE(image.pixelColor(50, 20), before.pixelColor(50, 20));
        QCOMPARE(image.pixelColor(38, 20).blue(), 255);
        int outline = 0, band = 0;
        for (int x = 30; x < 40; ++x) {
            const QColor pixel = image.pixelColor(x, 20);
            outline += pixel.blue() > 200 && pixel.red() < 150;
            band += pixel == QColor(255, 255, 255);
        }
        QVERIFY2(outline > 0 && band > 0, qPrintable(QString("%1 %2").arg(outline).arg(band)));
    }
    void manySelectedObjectsAreNotOutlined()
    {
        std::vector<app::Object> objects;
        for (int i = 0; i < 501; ++i)
            objects.push_back(object({{double(i % 90), 5}, {{{double(i % 90), 90}}}, false},
                                     {.stroke = app::Colour{}}));
        Stage stage(objects);
        app::ObjectRanges selected(app::ObjectRange{0, 500});
        stage.options.selection = selected.ranges();
        QVERIFY(!stage.picture().selected.polylines.empty());
        selected.insert(500);
        stage.options.selection = selected.ranges();
        QVERIFY(stage.picture().selected.polylines.empty());
    }
    void bandsTogetherAreTheWhole()
    {
        std::vector<app::Object> objects;
        for (int i = 0; i < 40; ++i) {
            app::Subpath path = square({i * 2.3, i * 1.9}, 11);
            path.closed = i % 2 == 0;
            objects.push_back(object(path, {.stroke = app::Colour{},
                                            .fill = app::Colour{200, 0, 0},
                                            .width = i * 0.2,
                                            .cap = app::Cap(i % 3)}));
        }
        Stage stage(objects);
        const app::Picture picture = stage.picture();
        const QImage whole = app::rasterised(picture, {0, 100}, {100, 1, 0.32});
        std::vector<QImage> parts;
        for (const app::Band band : app::bandsOf(100, 7))
            parts.push_back(app::rasterised(picture, band, {100, 1, 0.32}));
        const QImage all = joined(parts);
        QCOMPARE(all.size(), whole.size());
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 100; ++x)
                QVERIFY(std::abs(qAlpha(all.pixel(x, y)) - qAlpha(whole.pixel(x, y))) <= 3);
    }

    void whatDiffersIsThickerAndTicked()
    {
        Stage stage({filledSquare({10, 10}, 20)});
        const double nan = std::nan("");
        // A long one, a point, one outside the view, one that is not a number, and none any more.
        const std::vector<clipping::Clipped> pieces{{{{10, 50}, {40, 50}}, 0, 0},
                                                    {{{60.5, 60.5}, {60.5, 60.5}}, 0, 0},
                                                    {{{200, 200}, {300, 200}}, 0, 0},
                                                    {{{10, nan}, {40, 50}}, 0, 0},
                                                    {{{10, 80}, {40, 80}}, 99, 0}};
        stage.options.differing = pieces;
        stage.options.marked = {200, 0, 150};
        const app::DrawList marks = stage.picture().differing;
        for (const app::DrawCommand& command : marks.commands) {
            QVERIFY(command.stroke && command.stroke->width >= 2.25); // its own is 1
            QCOMPARE(command.stroke->colour, stage.options.marked);
        }
        const auto magenta = [&](int x, int y) {
            const QColor pixel = stage.image().pixelColor(x, y);
            return pixel.alpha() > 200 && pixel.red() > 190 && pixel.green() < 20;
        };
        QVERIFY(magenta(20, 50));
        QVERIFY(magenta(60, 60));
        QVERIFY(!magenta(25, 47)); // the middle of the long one: no tick
        stage.options.ticks = app::PictureOptions::Ticks::Everywhere;
        QVERIFY(magenta(25, 47));
        QVERIFY(magenta(60, 60));
        QVERIFY(!magenta(25, 80));
        // Always thicker than the line itself.
        stage.options.view.zoom = 4;
        QCOMPARE(stage.picture().differing.commands.front().stroke->width, 4 + 1.5);
        stage.options.differing = {};
        QVERIFY(stage.picture().differing.commands.empty());
    }
    // A file may hold the same line a hundred thousand times.
    void opaqueLinesThatLieOnOneAnotherArePaintedOnce()
    {
        app::Object line =
            object({{5, 5}, {{{45, 60}}}, false}, {.stroke = app::Colour{0, 0, 200}});
        const app::Object other = object({{5, 6}, {{{45, 60}}}, false}, line.style);
        const app::Object nearly = object({{5, 5 + 1e-12}, {{{45, 60}}}, false}, line.style);
        app::Object wider = line;
        wider.style.width = 3;
        const auto polylinesOf = [](const std::vector<app::Object>& objects) {
            return Stage(objects).picture().kept.polylines.size();
        };
        QCOMPARE(polylinesOf({line}), 1u);
        QCOMPARE(polylinesOf(std::vector(1000, line)), 1u);
        QCOMPARE(polylinesOf({line, other, line, other, line}), 2u);
        QCOMPARE(polylinesOf({line, wider, line}), 3u); // the last one is over the wider one
        QCOMPARE(polylinesOf({line, nearly}), 2u); // two lines, whatever is painted before them
        QCOMPARE(polylinesOf({other, line, nearly}), 3u);
        line.style.stroke->alpha = 128;
        QCOMPARE(polylinesOf(std::vector(1000, line)), 1000u); // they add up
        line.style.stroke->alpha = 255;
        line.style.dashes = {4, 2};
        const auto dashes = polylinesOf({line});
        QVERIFY(dashes > 5);
        QCOMPARE(polylinesOf(std::vector(1000, line)), dashes);
    }
};

} // namespace view_picture_test

TEST_CLASS(view_picture_test::PictureTest, Core)
#include "tests/app/view/picture_test.moc"

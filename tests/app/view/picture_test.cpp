// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/ink.h"
#include "app/view/picture.h"
#include "app/view/raster.h"

#include <QTest>

#include <cmath>

#include "tests/app/document/sheet_edits.h"

namespace {

app::Shape square(app::Point min, double side)
{
    app::Shape shape;
    shape.paths.push_back(
        {min, {{{min.x + side, min.y}}, {min + side}, {{min.x, min.y + side}}}, true});
    shape.style.stroke = app::Colour{};
    shape.style.fill = app::Colour{200, 0, 0};
    return shape;
}

// One pixel to the unit, 100 x 100, the window the left half.
struct Stage {
    explicit Stage(std::vector<app::Shape> shapes)
    {
        app::Sheet sheet;
        sheet.page = {{0, 0}, {100, 100}, {100, app::Unit::Px}, {100, app::Unit::Px}};
        sheet.window = {{0, 0}, {50, 100}};
        sheet.shapes = std::move(shapes);
        ::load(session.document, std::move(sheet));
        options.view.size = {100, 100};
        options.view.centre = {50, 50};
    }
    app::Picture picture()
    {
        const auto frame =
            session.scene.clip(session.uses(), session.sheet().window, app::Scene::Removed::Kept);
        return app::picture(session.sheet(), session.scene, frame, options);
    }
    QImage image() { return app::rasterised(picture(), {0, 100}, {100, 1, 0.32}); }

    app::Session session;
    app::PictureOptions options;
};

std::size_t fillsIn(const app::Plate& plate)
{
    return std::size_t(
        std::ranges::count_if(plate.coats, [](const auto& coat) { return !coat.stroke; }));
}

} // namespace

class PictureTest : public QObject {
    Q_OBJECT

private slots:
    void onlyWholeShapesAreFilled()
    {
        Stage stage({square({10, 10}, 20), square({40, 10}, 20), square({70, 10}, 20)});
        const app::Picture picture = stage.picture();
        QCOMPARE(fillsIn(picture.kept), std::size_t(1));
        QCOMPARE(fillsIn(picture.ghost), std::size_t(1));
        const QImage image = stage.image();
        QCOMPARE(image.pixelColor(20, 20), QColor(200, 0, 0));
        QCOMPARE(image.pixelColor(45, 20).alpha(), 0);
        QVERIFY(std::abs(image.pixelColor(80, 20).alpha() - 0.32 * 255) < 2);
    }
    void theRemovedPartIsHiddenOrShown()
    {
        Stage stage({square({40, 10}, 20), square({70, 10}, 20)});
        stage.options.removed = app::RemovedPart::Hidden;
        QCOMPARE(stage.image().pixelColor(80, 20).alpha(), 0);
        stage.options.removed = app::RemovedPart::Shown;
        QCOMPARE(stage.image().pixelColor(80, 20), QColor(200, 0, 0));
        QCOMPARE(stage.image().pixelColor(45, 20), QColor(200, 0, 0));
    }
    void aProjectorGetsWiderStrokesAndGhostsThatCanBeSeen()
    {
        Stage stage({square({40, 10}, 20)});
        const double width = stage.picture().kept.coats.front().stroke->width;
        stage.options.strokes = 2;
        stage.options.ghosting = app::Ghosting{{255, 255, 255}, 0.32};
        const app::Picture picture = stage.picture();
        QCOMPARE(picture.kept.coats.front().stroke->width, 2 * width);
        QVERIFY(app::contrast(picture.ghost.coats.front().stroke->colour, {255, 255, 255}) >= 3);
    }
    void theOutsideCanBeKept()
    {
        Stage stage({square({10, 10}, 20), square({70, 10}, 20)});
        stage.options.keep = app::Keep::Outside;
        QCOMPARE(stage.image().pixelColor(80, 20), QColor(200, 0, 0));
        QVERIFY(std::abs(stage.image().pixelColor(20, 20).alpha() - 0.32 * 255) < 2);
    }
    void anAreaWithoutStrokeIsOutlinedWhenCut()
    {
        app::Shape shape = square({40, 10}, 20);
        shape.style.stroke.reset();
        Stage stage({shape});
        const app::Picture picture = stage.picture();
        QCOMPARE(picture.kept.coats.size(), std::size_t(1));
        QCOMPARE(picture.kept.coats[0].stroke->colour, (app::Colour{200, 0, 0}));
    }
    void oneStrokeIsOneChainAndCutEndsAreButt()
    {
        app::Shape shape;
        shape.style.stroke = app::Colour{};
        shape.style.cap = app::Cap::Round;
        shape.paths.push_back({{10, 10}, {{{30, 12}}, {{30, 40}}, {{80, 40}}}, false});
        Stage stage({shape});
        const app::Picture picture = stage.picture();
        QCOMPARE(picture.kept.chains.size(), std::size_t(1));
        QCOMPARE(picture.kept.chains[0].count, 4U);
        QVERIFY(picture.kept.chains[0].capAtStart && !picture.kept.chains[0].capAtEnd);
        QCOMPARE(picture.ghost.chains.size(), std::size_t(1));
        QVERIFY(!picture.ghost.chains[0].capAtStart && picture.ghost.chains[0].capAtEnd);
        QCOMPARE(picture.kept.points.back(), QPointF(50, 40));
    }
    void deepZoomHandsOutNoHugeNumbers()
    {
        Stage stage({square({-1e6, -1e6}, 2.1e6), square({10, 10}, 20)});
        ::setWindow(stage.session.document, {{-2e6, -2e6}, {2e6, 2e6}});
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
        app::Shape shape;
        shape.style.stroke = app::Colour{};
        shape.style.dashes = {10, 10};
        shape.style.width = 2;
        shape.paths.push_back({{5, 50}, {{{95, 50}}}, false});
        Stage stage({shape});
        const QImage image = stage.image();
        for (int x = 6; x < 94; ++x)
            if ((x - 5) % 10 != 0 && (x - 5) % 10 != 9 && std::abs(x - 50) > 1)
                QCOMPARE(image.pixelColor(x, 50).alpha() > 0, (x - 5) % 20 < 10);
    }
    void theSelectionIsLitWhole()
    {
        Stage stage({square({40, 10}, 20)});
        stage.options.selection = {0};
        stage.options.light = {0, 0, 255};
        const app::Picture picture = stage.picture();
        QCOMPARE(picture.lit.chains.size(), std::size_t(1));
        QCOMPARE(picture.lit.chains[0].count, 5U);
    }
    void bandsTogetherAreTheWhole()
    {
        std::vector<app::Shape> shapes;
        for (int i = 0; i < 40; ++i) {
            app::Shape shape = square({i * 2.3, i * 1.9}, 11);
            shape.style.width = i * 0.2;
            shape.style.cap = app::Cap(i % 3);
            shape.paths[0].closed = i % 2 == 0;
            shapes.push_back(shape);
        }
        Stage stage(std::move(shapes));
        const app::Picture picture = stage.picture();
        const QImage whole = app::rasterised(picture, {0, 100}, {100, 1, 0.32});
        std::vector<QImage> parts;
        for (const app::Band band : app::bandsOf(100, 7))
            parts.push_back(app::rasterised(picture, band, {100, 1, 0.32}));
        QCOMPARE(app::joined(parts).size(), whole.size());
        const QImage joined = app::joined(parts);
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 100; ++x)
                QVERIFY(std::abs(qAlpha(joined.pixel(x, y)) - qAlpha(whole.pixel(x, y))) <= 3);
    }

    void whatDiffersIsThickerAndTicked()
    {
        Stage stage({square({10, 10}, 20)});
        const double nan = std::nan("");
        // A long one, a point, one outside the view, one that is not a number, and none any more.
        const std::vector<clipping::Clipped> pieces{{{{10, 50}, {40, 50}}, 0, 0},
                                                    {{{60.5, 60.5}, {60.5, 60.5}}, 0, 0},
                                                    {{{200, 200}, {300, 200}}, 0, 0},
                                                    {{{10, nan}, {40, 50}}, 0, 0},
                                                    {{{10, 80}, {40, 80}}, 99, 0}};
        stage.options.differing = pieces;
        stage.options.marked = {200, 0, 150};
        const app::Plate marks = stage.picture().differing;
        for (const app::Coat& coat : marks.coats) {
            QVERIFY(coat.stroke && coat.stroke->width >= 2.25); // its own is 1
            QCOMPARE(coat.stroke->colour, stage.options.marked);
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
        QCOMPARE(stage.picture().differing.coats.front().stroke->width, 4 + 1.5);
        stage.options.differing = {};
        QVERIFY(stage.picture().differing.coats.empty());
    }
    // A file may hold the same line a hundred thousand times.
    void opaqueLinesThatLieOnOneAnotherArePaintedOnce()
    {
        app::Shape line;
        line.paths.push_back({{5, 5}, {{{45, 60}}}, false});
        line.style.stroke = app::Colour{0, 0, 200};
        app::Shape other = line;
        other.paths.front().start = {5, 6};
        app::Shape wider = line;
        wider.style.width = 3;
        const auto chainsOf = [](const std::vector<app::Shape>& shapes) {
            return Stage(shapes).picture().kept.chains.size();
        };
        QCOMPARE(chainsOf({line}), 1u);
        QCOMPARE(chainsOf(std::vector(1000, line)), 1u);
        QCOMPARE(chainsOf({line, other, line, other, line}), 2u);
        QCOMPARE(chainsOf({line, wider, line}), 3u); // the last one is over the wider one
        line.style.stroke->alpha = 128;
        QCOMPARE(chainsOf(std::vector(1000, line)), 1000u); // they add up
        line.style.stroke->alpha = 255;
        line.style.dashes = {4, 2};
        const auto dashes = chainsOf({line});
        QVERIFY(dashes > 5);
        QCOMPARE(chainsOf(std::vector(1000, line)), dashes);
    }
};

QTEST_GUILESS_MAIN(PictureTest)
#include "picture_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Clip windows of all shapes together: what is kept of lines, compared with points of them.
#include "app/cut/cut.h"
#include "app/document/document_builder.h"
#include "app/document/recipe_outline.h"
#include "app/document/window_outline.h"
#include "app/scene/scene.h"

#include <QTest>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <random>

#include "tests/app/scene/block_scene.h"
#include "tests/test_class.h"

namespace scene_shaped_region_test {

using namespace app;
using clipping::Clipped;
using clipping::Segment;

namespace {

constexpr double tolerance = 0.01;

PathShape shapeOf(const Recipe& recipe, FillRule rule = FillRule::NonZero)
{
    const auto outline = outlineOf(recipe);
    return {Path({&*outline, 1}), rule, recipe};
}

std::vector<Segment> keptOf(const std::vector<Segment>& lines, const ClipWindows& windows,
                            const Page& page)
{
    const ClipRegion region = shownRegionOf(windows, page);
    RegionClipping clipping;
    clipping.start(region, clipping::exactAlgorithm().corrected.clipAll);
    std::vector<Clipped> kept;
    clipping.fold(lines, 0, kept);
    std::vector<Segment> pieces;
    for (const Clipped& piece : kept)
        pieces.push_back(piece.segment);
    return pieces;
}

/// A rotated rectangle and a pentagram, of which a circle is cut out.
ClipWindows windows(Keep keep)
{
    const Subpath pentagram{{70, 10}, {{{88, 65}}, {{41, 31}}, {{99, 31}}, {{52, 65}}}, true};
    return {{{.shape = RectangleShape{{{10, 10}, {60, 50}}, 0.4}},
             {.shape = PathShape{Path({&pentagram, 1}), FillRule::EvenOdd}},
             {.shape = RectangleShape{{{0, 60}, {100, 90}}}},
             {.shape = shapeOf(EllipseRecipe{{45, 50}, {20, 15}}),
              .operation = WindowOperation::CutOut}},
            keep};
}

double distanceTo(const Point& p, const Point& a, const Point& b)
{
    const Point way = b - a;
    const double along = glm::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0);
    return glm::distance(p, a + way * along);
}

/// Whether a point is in a window; empty if it is too near its border to say.
std::optional<bool> isIn(const WindowShape& shape, const Point& p)
{
    const WindowOutline outline = outlineOf(shape, tolerance);
    int winding = 0, crossings = 0;
    for (const auto& ring : outline.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if (distanceTo(p, a, b) < 1e-9)
                return std::nullopt;
            if ((a.y <= p.y) != (b.y <= p.y)
                && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) {
                ++crossings;
                winding += b.y > a.y ? 1 : -1;
            }
        }
    return outline.rule == FillRule::EvenOdd ? crossings % 2 == 1 : winding != 0;
}

std::optional<bool> isKept(const ClipWindows& all, const Point& p)
{
    bool in = all.list.front().operation != WindowOperation::Add;
    for (const ClipWindow& window : all.list) {
        const auto here = isIn(window.shape, p);
        if (!here)
            return std::nullopt;
        in = window.operation == WindowOperation::Add       ? in || *here
             : window.operation == WindowOperation::CutOut  ? in && !*here
             : window.operation == WindowOperation::Replace ? *here
                                                            : in && *here;
    }
    return in == (all.keep == Keep::Inside);
}

std::vector<Segment> randomLines(std::size_t count)
{
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> place(-10, 110);
    std::vector<Segment> lines;
    while (lines.size() < count)
        lines.push_back({{place(random), place(random)}, {place(random), place(random)}});
    return lines;
}

} // namespace

class ShapedRegionTest : public QObject {
    Q_OBJECT

private slots:
    void everyPointOfALineIsDecidedAsTheWindowsSay_data()
    {
        QTest::addColumn<int>("keep");
        QTest::addColumn<bool>("replaced");
        QTest::addRow("inside") << int(Keep::Inside) << false;
        QTest::addRow("outside") << int(Keep::Outside) << false;
        QTest::addRow("one replaced") << int(Keep::Inside) << true;
        QTest::addRow("one replaced, outside") << int(Keep::Outside) << true;
    }
    void everyPointOfALineIsDecidedAsTheWindowsSay()
    {
        QFETCH(const int, keep);
        QFETCH(const bool, replaced);
        ClipWindows all = windows(Keep(keep));
        if (replaced)
            all.list[1].operation = WindowOperation::Replace;
        const ClipRegion region = regionOf(all, tolerance);
        const auto lines = randomLines(400);
        RegionClipping clipping;
        clipping.start(region, clipping::exactAlgorithm().corrected.clipAll);
        std::vector<Clipped> kept;
        clipping.fold(lines, 0, kept);
        std::size_t next = 0, looked = 0, seen = 0;
        for (std::uint32_t line = 0; line < lines.size(); ++line) {
            const std::size_t first = next;
            while (next < kept.size() && kept[next].source == line)
                ++next;
            const auto& [a, b] = lines[line];
            for (int i = 1; i < 50; ++i) {
                const Point p = a + (b - a) * (i / 50.0);
                const auto expected = isKept(all, p);
                if (!expected)
                    continue;
                const bool found = std::any_of(
                    kept.begin() + std::ptrdiff_t(first), kept.begin() + std::ptrdiff_t(next),
                    [&](const Clipped& piece) {
                        return glm::distance(piece.segment.a, p) + glm::distance(p, piece.segment.b)
                               < glm::distance(piece.segment.a, piece.segment.b) + 1e-9;
                    });
                QCOMPARE(found, *expected);
                ++looked;
                seen += found;
            }
        }
        QCOMPARE(next, kept.size());
        QVERIFY(looked > 19'000 && seen > 3'000 && seen < looked - 3'000);
    }
    void theSceneShowsTheSameForEveryAlgorithm()
    {
        DocumentBuilder builder;
        builder.open({.name = "Lines"});
        const StyleEntry style = builder.style({.stroke = Colour{}});
        const auto lines = randomLines(3000);
        for (const Segment& line : lines)
            builder.addLine(line, style);
        builder.close();
        EditedDocument document;
        document.load(builder.take({}));
        Scene scene(document);
        const ClipRegion region = regionOf(windows(Keep::Inside), tolerance);
        RegionClipping clipping;
        clipping.start(region, clipping::exactAlgorithm().corrected.clipAll);
        std::vector<Clipped> all;
        clipping.fold(lines, 0, all);
        std::size_t visible = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
            visible += i == 0 || all[i].source != all[i - 1].source;
        for (const clipping::Algorithm& algorithm : clipping::algorithms())
            QCOMPARE(visibleIn(scene.lines(), region, {&algorithm}), visible);
    }
    void aBoxIsWholeOrGoneOnlyIfAllOfItIs()
    {
        const ClipWindows all = windows(Keep::Inside);
        const ClipRegion region = regionOf(all, tolerance);
        QCOMPARE(remainsOf(region, {{70, 80}, {80, 85}}), Remains::Whole);
        QCOMPARE(remainsOf(region, {{-9, -9}, {-5, 100}}), Remains::Gone);
        QCOMPARE(remainsOf(region, {{30, 25}, {31, 26}}), Remains::Whole);  // in the rotated one
        QCOMPARE(remainsOf(region, {{29, 39}, {31, 41}}), Remains::Pieces); // at the circle
        QVERIFY(!region.single() && region.prepared);
    }
    void aSingleWindowIsPreparedOnce()
    {
        ClipWindows all = windows(Keep::Inside);
        all.list = {all.list[1]};
        const ClipRegion inside = regionOf(all, tolerance);
        QVERIFY(inside.prepared && inside.prepared == inside.steps[0].area);
        const ClipRegion outside = app::withKeep(inside, Keep::Outside);
        QVERIFY(outside.prepared && outside.prepared != inside.prepared);
    }
    void aWindowWithoutAreaBesideAShapeKeepsNothing()
    {
        ClipWindows all = windows(Keep::Inside);
        all.list = {all.list[0], {.shape = RectangleShape{{{5, 95}, {5, 99}}}}};
        const ClipRegion region = regionOf(all, tolerance);
        QCOMPARE(remainsOf(region, {{5, 96}, {5, 97}}), Remains::Gone);
        RegionClipping clipping;
        clipping.start(region, clipping::exactAlgorithm().corrected.clipAll);
        std::vector<Clipped> kept;
        clipping.fold(std::vector{Segment{{5, 96}, {5, 97}}}, 0, kept);
        QCOMPARE(kept.size(), 0u);
    }
    void aDrawingIsCutAtItsShapes()
    {
        const Subpath line{{0, 50}, {{{100, 50}}}, false};
        const Subpath wave{{0, 20}, {{{100, 20}, {30, 80}, {60, -40}, true}}, false};
        CutOptions options{clipping::exactAlgorithm().corrected.clipAll};
        options.region = regionOf({{{.shape = shapeOf(EllipseRecipe{{50, 50}, {20, 20}})}}}, 0.001);
        options.tolerance = 0.001;
        const auto part = cutAlone({Path({&line, 1}), {.stroke = Colour{}}}, options);
        QCOMPARE(part.size(), 1u);
        const auto left = part[0].path.subpaths();
        QCOMPARE(left.size(), 1u);
        QVERIFY(left[0].start == Point(30, 50) && left[0].segments.back().to == Point(70, 50));
        options.region = regionOf(
            {{{.shape = shapeOf(EllipseRecipe{{50, 50}, {20, 20}})}}, Keep::Outside}, 0.001);
        const auto outside = cutAlone({Path({&line, 1}), {.stroke = Colour{}}}, options);
        QCOMPARE(outside[0].path.subpaths().size(), 2u);
        const auto curve = cutAlone({Path({&wave, 1}), {.stroke = Colour{}}}, options);
        for (const Subpath& piece : curve[0].path.subpaths())
            for (const PathSegment& segment : piece.segments)
                QVERIFY(segment.curved); // curves stay curves
    }
    /// A window made of an object, or of its neighbour, which has the common border backwards.
    void whatLiesOnACurveIsInItsWindow()
    {
        const Page page;
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> place(10, 90);
        const auto at = [&] { return Point(place(random), place(random)); };
        for (int i = 0; i < 100; ++i) {
            Subpath blob{at(), {}, true};
            for (int k = 0; k < i % 4; ++k) // none: a loop of one curve
                blob.segments.push_back({at(), at(), at(), true});
            blob.segments.push_back({blob.start, at(), at(), true});
            const Subpath back = reversedPath(blob);
            for (const Subpath& drawn : {blob, back}) {
                std::vector<Chord> chords;
                flatten(drawn, usualTolerance(page), chords);
                std::vector<Segment> lines;
                for (const Chord& chord : chords)
                    lines.push_back(chord.segment);
                ClipWindows all{{{.shape = PathShape{Path({&blob, 1}), FillRule::NonZero}}}};
                QCOMPARE(keptOf(lines, all, page), lines);
                all.keep = Keep::Outside;
                QVERIFY(keptOf(lines, all, page).empty());
            }
        }
    }
    /// Its chords are those of Bézier curves, which are beyond the ellipse here and there.
    void whatLiesOnAnEllipseIsInItsWindow()
    {
        const Page page;
        for (const double radius : {0.1, 4.0, 50.0, 300.0})
            for (const Point& radii : {Point(radius), Point(radius, radius / 3)}) {
                const EllipseRecipe ellipse{{37.3, 41.9}, radii};
                std::vector<Chord> chords;
                flatten(*outlineOf(Recipe(ellipse)), usualTolerance(page), chords);
                std::vector<Segment> lines;
                for (const Chord& chord : chords)
                    lines.push_back(chord.segment);
                ClipWindows all{{{.shape = shapeOf(ellipse)}}};
                QCOMPARE(keptOf(lines, all, page), lines);
                all.keep = Keep::Outside;
                QVERIFY(keptOf(lines, all, page).empty());
                all = {{{.shape = shapeOf(ellipse), .operation = WindowOperation::CutOut}}};
                QVERIFY(keptOf(lines, all, page).empty());
            }
    }
    void windowsWithoutAreaKeepNothing()
    {
        for (const WindowShape& shape :
             {WindowShape(PathShape{}), WindowShape(RectangleShape{{{5, 5}, {5, 9}}, 0.3}),
              WindowShape(PathShape{Path(Segment{{0, 0}, {9, 9}})})}) {
            const ClipRegion region = regionOf({{{.shape = shape}}}, tolerance);
            RegionClipping clipping;
            clipping.start(region, clipping::exactAlgorithm().corrected.clipAll);
            std::vector<Clipped> kept;
            clipping.fold(randomLines(50), 0, kept);
            QCOMPARE(kept.size(), 0u);
        }
    }
};

} // namespace scene_shaped_region_test

TEST_CLASS(scene_shaped_region_test::ShapedRegionTest, None)
#include "tests/app/scene/shaped_region_test.moc"

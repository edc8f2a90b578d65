// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/picking.h"
#include "clipping/algorithm.h"

#include <QTest>

#include <glm/common.hpp>

#include "tests/app/view/random_drawing.h"
#include "tests/replaced_heap.h"
#include "tests/test_class.h"

namespace {

thread_local std::size_t allocated = 0; // bytes

} // namespace

// Adds up what is taken from the heap.
bool heapRefuses(std::size_t size)
{
    allocated += size;
    return false;
}

namespace {

using Box = app::Picking::Box;
using app::Point;
using clipping::Segment;
using Found = std::optional<std::size_t>;

app::Object line(const Point& a, const Point& b)
{
    return {app::Path(Segment{a, b}), {.stroke = app::Colour{}}};
}

app::Document documentOf(const std::vector<std::vector<app::Object>>& layers)
{
    app::DocumentBuilder builder;
    for (const auto& objects : layers) {
        builder.open({.name = "layer"});
        for (const app::Object& object : objects)
            builder.add(object);
        builder.close();
    }
    return builder.take({});
}

/// Exchanges objects for as many others.
void replace(app::EditedDocument& document, std::size_t first, const std::vector<app::Object>& by)
{
    app::Edit edit;
    edit.splices = {{std::uint32_t(first), std::uint32_t(by.size()), std::uint32_t(by.size())}};
    edit.objects = document.now().objects().slice(0, 0);
    for (const app::Object& object : by)
        edit.objects.append(object);
    document.apply(edit);
}

void setLayer(app::EditedDocument& document, std::size_t at, bool visible, bool locked)
{
    app::Edit edit;
    const app::Containers& tree = document.now().containers();
    app::Container layer = tree[tree.childrenOf(0)[at]];
    layer.visible = visible;
    layer.locked = locked;
    edit.containers = tree.with(layer);
    document.apply(edit);
}

struct Stage {
    explicit Stage(app::Document of) : document(std::move(of)) {}
    const app::SceneLines& lines() const { return scene.lines(); }
    std::vector<Segment> linesOf(std::size_t object) const
    {
        std::vector<Segment> all;
        for (auto i = lines().firstLineOf(object); i < lines().firstLineOf(object + 1); ++i)
            all.push_back(lines()[i]);
        return all;
    }

    app::EditedDocument document;
    app::Scene scene{document};
    app::Picking picking{document, scene};
};

app::Document scattered(std::mt19937_64& random, std::size_t count)
{
    std::uniform_real_distribution<double> place(-100, 100), step(-20, 20);
    std::vector<app::Object> objects;
    for (std::size_t i = 0; i < count; ++i) {
        const Point a(place(random), place(random));
        const Point along(step(random), step(random));
        const Point to[] = {
            a + Point(along.x, 0), a + Point(0, along.y), {place(random), place(random)}, a};
        objects.push_back(line(a, to[i % 4]));
    }
    return documentOf({objects});
}

bool contains(const clipping::Window& w, const Point& p)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

} // namespace

class PickingTest : public QObject {
    Q_OBJECT

private slots:
    void nearFindsWhatLookingAtAllFinds()
    {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> place(-130, 130), radius(0, 15);
        Stage stage(scattered(random, 20'000));
        for (int round = 0; round < 300; ++round) {
            if (round % 50 == 49)
                replace(stage.document, 60 * std::size_t(round),
                        {line({place(random), 0}, {0, place(random)}), line({}, {})});
            const Point p(place(random), place(random));
            const double r = radius(random);
            std::vector<std::size_t> all;
            for (const auto& run : stage.lines().runs())
                for (std::size_t i = 0; i < run.segments.size(); ++i)
                    if (app::distance(p, run.segments[i]) <= r)
                        all.push_back(run.firstLine + i);
            QCOMPARE(stage.picking.near(p, r), all);
        }
    }
    void gridsOfLargeDrawingsAreLaidMeanwhile()
    {
        std::mt19937_64 random(9);
        Stage stage(scattered(random, 20'000));
        const Point p(3, 4);
        const app::NearLimits few{.looks = 2000};
        const auto all = stage.picking.near(p, 2);
        QVERIFY(!all.empty());
        QVERIFY(stage.picking.near(p, 2, few) != all); // it looks at every line
        QTRY_COMPARE_WITH_TIMEOUT(stage.picking.near(p, 2, few), all, 60'000);
    }
    void anEditCostsTheGridsOfItsBlocks()
    {
        std::mt19937_64 random(6);
        Stage stage(scattered(random, 40'000));
        const auto takenFor = [&](const Point& point) {
            const std::size_t before = allocated;
            stage.picking.near(point, 1);
            return allocated - before;
        };
        const std::size_t blocks = stage.lines().blocks().size();
        QVERIFY(blocks >= 5);
        const std::size_t grid = takenFor({0, 0}) / blocks;
        QVERIFY(takenFor({0, 0}) < grid / 4);
        replace(stage.document, 7, {line({}, {1, 1})});
        QVERIFY(takenFor({1e6, 1e6}) < grid / 4); // none yet: it is far away
        const std::size_t again = takenFor({0, 0});
        QVERIFY(again > grid / 2 && again < grid * 3 / 2);
        QVERIFY(takenFor({0, 0}) < grid / 4);
    }
    void linesThatAreNotFiniteAreNotNear()
    {
        const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
        Stage stage(documentOf({{line({nan, 0}, {1, 1}), line({0, 0}, {infinity, 1}),
                                 line({-infinity, -infinity}, {infinity, 0}), line({3, 3}, {4, 4}),
                                 line({1e300, 0}, {-1e300, 0})}}));
        QCOMPARE(stage.picking.near({3, 3}, 1), std::vector<std::size_t>{3});
        QVERIFY(stage.picking.near({30, 3}, 1).empty());
        QCOMPARE(stage.picking.nearest({3, 3}, 1), Found(3));
        QCOMPARE(stage.picking.nearest({30, 3}, 1), Found());
        QVERIFY(!stage.picking.areaAt({3, 3}));
    }
    // Above a line, in a large drawing as long as its grids are not laid, too.
    void linesWhoseDistanceIsNoNumberAreNotPicked()
    {
        for (const std::size_t more : {0, 20'000}) {
            std::vector<app::Object> objects(more, line({50, 50}, {51, 50}));
            objects.push_back(line({0, 0}, {10, 0}));
            for (const double far : {1e160, 1e200, 1e300, std::nan("")})
                objects.push_back(line({-far, -far}, {far, far}));
            Stage stage(documentOf({objects}));
            QCOMPARE(stage.picking.nearest({5, 0.01}, 8), Found(more));
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
        const app::Object bar = line({0, 0}, {10, 0});
        Stage stage(documentOf({{bar}, {bar}}));
        QCOMPARE(stage.picking.nearest({5, 1}, 2), Found(1));
        setLayer(stage.document, 1, true, true);
        QCOMPARE(stage.picking.nearest({5, 1}, 2), Found(0));
        setLayer(stage.document, 0, false, false);
        QCOMPARE(stage.picking.nearest({5, 1}, 2), std::nullopt);
    }
    void theTopmostUnderThePointOrTheNearestIsPicked()
    {
        std::mt19937_64 random(8);
        std::uniform_real_distribution<double> place(-100, 100);
        for (const std::size_t count : {3'000, 20'000, 200'000}) {
            const Stage stage(scattered(random, count));
            int under = 0, near = 0;
            for (int round = 0; round < 60; ++round) {
                const Point p(place(random), place(random));
                const double radius = 0.002 * (1 << round % 12);
                Found nearest, topmost;
                double least = radius;
                for (std::size_t i = 0; i < count; ++i) {
                    const double d = app::distance(p, stage.lines()[i]);
                    if (d <= least)
                        least = d, nearest = i;
                    if (d <= radius / 32)
                        topmost = i;
                }
                QCOMPARE(stage.picking.nearest(p, radius), topmost ? topmost : nearest);
                under += topmost.has_value();
                near += nearest && !topmost;
            }
            QVERIFY(under > 0 && near > 0);
        }
    }
    void lockedLinesOfOtherBlocksAreNotPicked()
    {
        std::mt19937_64 random(9);
        std::vector<app::Object> crowd(70'000, line({0, 0}, {10, 0}));
        Stage stage(documentOf({{line({0, 0.01}, {10, 0.01})}, crowd}));
        QVERIFY(stage.lines().blocks().size() > 1);
        QCOMPARE(stage.picking.nearest({5, 0.01}, 2), Found(70'000)); // as good as under the point
        setLayer(stage.document, 1, true, true);
        QCOMPARE(stage.picking.nearest({5, 0.01}, 2), Found(0));
        QCOMPARE(stage.picking.nearest({5, 1}, 0.5), std::nullopt);
    }
    void areasArePickedByTheirRule()
    {
        std::vector<app::Subpath> rings; // two squares, turning the same way
        for (const double r : {10.0, 5.0})
            rings.push_back({{-r, -r}, {{{r, -r}}, {{r, r}}, {{-r, r}}}, true});
        app::Object below{app::Path(rings), {.fill = app::Colour{}}}, above = below;
        above.style.fillRule = app::FillRule::EvenOdd;
        Stage stage(documentOf({{below, above}}));
        QCOMPARE(stage.picking.areaAt({7, 0}), Found(1));
        QCOMPARE(stage.picking.areaAt({0, 0}), Found(0)); // through the hole
        QCOMPARE(stage.picking.areaAt({12, 0}), std::nullopt);
    }
    void openPathsAreFilledAsIfClosed()
    {
        const std::vector<app::Subpath> angle{{{0, 0}, {{{10, 0}}, {{10, 10}}}, false}};
        Stage stage(documentOf({{{app::Path(angle), {.fill = app::Colour{}}}}}));
        QCOMPARE(stage.picking.areaAt({8, 4}), Found(0));
        QCOMPARE(stage.picking.areaAt({2, 4}), std::nullopt);
        QCOMPARE(stage.picking.areaAt({-50, 4}), std::nullopt);
    }
    void areasAndBoxesFindWhatLookingAtAllFinds()
    {
        std::size_t areas = 0, within = 0, touching = 0;
        for (unsigned seed = 1; seed <= 60; ++seed) {
            RandomDrawing random(seed);
            const Stage stage(seed % 30 == 0 ? random.longOutline() : random.document());
            for (int round = 0; round < 20; ++round) {
                const Point p = random.point() + Point(1e-3, 2e-3);
                QCOMPARE(stage.picking.areaAt(p), plainAreaAt(stage, p));
                const clipping::Window box = random.window();
                for (const Box rule : {Box::Contains, Box::Touches})
                    QCOMPARE(stage.picking.objectsIn(box, rule), plainObjectsIn(stage, box, rule));
                areas += stage.picking.areaAt(p).has_value();
                within += stage.picking.objectsIn(box, Box::Contains).size();
                touching += stage.picking.objectsIn(box, Box::Touches).size();
            }
        }
        QVERIFY(areas > 200 && within > 1000 && touching > 2 * within);
    }
    void aBoxContainsOrTouches()
    {
        Stage stage(documentOf({{line({1, 1}, {2, 2}), line({1, 1}, {20, 1}),
                                 line({20, 20}, {30, 30}), line({-5, 4}, {15, 4})}}));
        using Set = app::ObjectRanges;
        QCOMPARE(stage.picking.objectsIn({{0, 0}, {10, 10}}, Box::Contains), Set{0});
        QCOMPARE(stage.picking.objectsIn({{0, 0}, {10, 10}}, Box::Touches), (Set{0, 1, 3}));
    }

private:
    // Contour by contour; each is closed.
    static bool isInArea(const std::vector<Segment>& outline, app::FillRule rule, const Point& p)
    {
        int winding = 0, crossings = 0;
        const auto count = [&](const Segment& s) {
            if ((s.a.y <= p.y) == (s.b.y <= p.y)
                || s.a.x + (s.b.x - s.a.x) * ((p.y - s.a.y) / (s.b.y - s.a.y)) <= p.x)
                return;
            ++crossings;
            winding += s.b.y > s.a.y ? 1 : -1;
        };
        for (std::size_t i = 0, first = 0; i < outline.size(); ++i) {
            count(outline[i]);
            if (i + 1 < outline.size() && outline[i + 1].a == outline[i].b)
                continue;
            count({outline[i].b, outline[first].a});
            first = i + 1;
        }
        return rule == app::FillRule::EvenOdd ? crossings % 2 == 1 : winding != 0;
    }
    static Found plainAreaAt(const Stage& stage, const Point& p)
    {
        const auto& objects = stage.document.now().objects();
        for (std::size_t i = objects.size(); i-- > 0;) {
            const app::Style& style = objects[i].style();
            if (style.fill && stage.picking.pickable(i)
                && isInArea(stage.linesOf(i), style.fillRule, p))
                return i;
        }
        return std::nullopt;
    }
    static app::ObjectRanges plainObjectsIn(const Stage& stage, const clipping::Window& box,
                                            Box rule)
    {
        const auto within = [&](const Segment& s) {
            return contains(box, s.a) && contains(box, s.b);
        };
        const auto touches = [&](const Segment& s) {
            return clipping::exactAlgorithm().corrected.clip(s, box).has_value();
        };
        app::ObjectRanges found;
        for (std::size_t i = 0; i < stage.document.now().objects().size(); ++i) {
            const auto lines = stage.linesOf(i);
            const bool in = rule == Box::Contains ? std::ranges::all_of(lines, within)
                                                  : std::ranges::any_of(lines, touches);
            if (!lines.empty() && stage.picking.pickable(i) && in)
                found.insert(i);
        }
        return found;
    }
};

TEST_CLASS(PickingTest, Core)
#include "tests/app/view/picking_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/places.h"

#include <glm/geometric.hpp>

#include <random>

#include "tests/app/view/snapping/snap_stage.h"
#include "tests/test_class.h"

namespace view_snapping_snapper_test {

using app::Point;

namespace {

const app::ClipWindows oneWindow{{{.shape = app::RectangleShape{{{100, 100}, {200, 150}}}}}};

} // namespace

// Whatever of a drawing is snapped to.
class SnapperTest : public QObject {
    Q_OBJECT

private slots:
    void partsOfWhatIsLeftOutAreFound()
    {
        const SnapStage stage({objectOf(app::Subpath{{0, 0}, {{{50, 0}}, {{50, 40}}}, false})});
        const std::vector<app::Subpath> parts{
            {{50, 0}, {{{50, 40}}}, false},
            {{0, 20}, {{{30, 20}, {10, 30}, {20, 30}, true}}, false},
            {{70, 70}, {{{70, 70}}}, false}};
        app::SnapQuery query{{1, 1}, 3, app::SnapTo::Nothing.with("ends").with("middles")};
        query.without = {0};
        query.parts = &parts;
        const auto found = [&](const Point& pointer) {
            query.pointer = pointer;
            const auto snap = stage.snapper.at(query);
            return snap ? snap->point : Point(-1);
        };
        QCOMPARE(found({1, 1}), Point(-1)); // what moves
        QCOMPARE(found({51, 1}), Point(50, 0));
        QCOMPARE(found({49, 21}), Point(50, 20));
        QCOMPARE(found({31, 21}), Point(30, 20)); // of a curve
        QCOMPARE(found({71, 69}), Point(70, 70));
        query.to = query.to.with("drawn-alignment");
        query.seen = clipping::Window{{0, 0}, {100, 100}};
        QCOMPARE(found({72, 90}), Point(70, 90)); // in line with it
    }
    void everyKindIsFound_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<Point>("pointer");
        QTest::addColumn<QString>("found");
        const auto row = [](const char* kind, Point pointer, const char* found) {
            QTest::addRow("%s: %s", kind, found) << kind << pointer << found;
        };
        row("ends", {1, 1}, "0 0 end");
        row("ends", {11, 31}, "10 30 end");
        row("ends", {50, 0}, "nothing");
        row("ends", {251, 301}, "250 300 end"); // of a curve
        row("ends", {220, 349}, "nothing");     // of chords alone
        row("middles", {4, 16}, "5 15 middle");
        row("middles", {236, 336}, "235.355 335.355 middle");
        row("centres", {201, 301}, "200 300 centre");
        row("centres", {61, 59}, "60 60 centre"); // of a rectangle
        row("centres", {0, 0}, "nothing");
        row("intersections", {11, 9}, "10 10 intersection");
        row("intersections", {1, 1}, "nothing"); // where nothing crosses
        row("perpendicular", {19, 11}, "20 10 perpendicular");
        row("on-path", {17, 11}, "17 10 on path");
        row("window", {99, 120}, "100 120 window edge");
        row("window", {101, 101}, "100 100 window corner");
        row("window", {150, 125}, "nothing");
        row("guide", {121, 77}, "120 77 guide");
        row("guide", {77, 81}, "77 80 guide");
        row("guide", {121, 81}, "120 80 crossing of guides");
        row("guide", {124, 70}, "nothing");
        row("page", {2, 50}, "0 50 page edge");
        row("page", {296, 209}, "297 210 page corner");
    }
    void everyKindIsFound()
    {
        const app::Subpath arc{{250, 300}, {}, false};
        app::Subpath quarter = arc;
        const double k = 0.5522847498307936 * 50;
        quarter.segments.push_back({{200, 350}, {250, 300 + k}, {200 + k, 350}, true});
        SnapStage stage({lineFrom({0, 0}, {10, 30}), lineFrom({5, 10}, {30, 10}),
                         lineFrom({10, 5}, {10, 25}), objectOf(quarter),
                         objectOf(app::RectangleRecipe{{40, 50}, {40, 20}, 0})},
                        oneWindow);
        stage.guides.list = {{0, 120}, {1, 80}};
        QFETCH(QString, kind);
        QFETCH(Point, pointer);
        QTEST(stage.textAt(pointer, kind.toUtf8(), Point(20, 40)), "found");
        QCOMPARE(stage.textAt(pointer, ""), "nothing");
    }
    void anEndIsThePathsOwnBitForBit()
    {
        const Point end(0.1 + 0.2, -1.0 / 3);
        const SnapStage stage({lineFrom(end, {7, 9}), objectOf(app::Subpath{end, {}, false})});
        const auto snap = stage.at({0.5, 0.4}, "ends middles on-path");
        QVERIFY(snap && snap->point == end);
    }
    void aLineNearAnAxisRunsAlongIt()
    {
        const SnapStage stage({lineFrom({50, 9}, {51, 30})});
        QCOMPARE(stage.textAt({80, 22}, "axes", Point(20, 20)), "80 20 along an axis");
        QCOMPARE(stage.textAt({18.5, -40}, "axes", Point(20, 20)), "20 -40 along an axis");
        QCOMPARE(stage.textAt({80, 22}, "axes"), "nothing");                 // no line
        QCOMPARE(stage.textAt({40, 22}, "axes", Point(20, 20)), "nothing");  // over 3 degrees
        QCOMPARE(stage.textAt({200, 24}, "axes", Point(20, 20)), "nothing"); // too far away
        QCOMPARE(stage.textAt({50.4, 10}, "axes ends", Point(20, 10)), "50 9 end");
    }
    void aPointWinsOverAnEdgeAndTheNearestPointWins()
    {
        const SnapStage stage({lineFrom({0, 0}, {4, 0})}, oneWindow);
        QCOMPARE(stage.textAt({2.4, 1}, "ends middles on-path"), "2 0 middle");
        QCOMPARE(stage.textAt({3.4, 0.1}, "ends middles on-path"), "4 0 end");
        QCOMPARE(stage.textAt({1.2, 0}, "on-path middles"), "2 0 middle");
        QCOMPARE(stage.textAt({102, 99}, "window on-path"), "100 100 window corner");
    }
    void anEndIsNotCalledAnIntersection()
    {
        const SnapStage stage({lineFrom({0.1, 0.7}, {9, 4}), lineFrom({0.1, 0.7}, {3, 9})});
        QCOMPARE(stage.at({0.3, 0.5}, "ends intersections")->kind->key, "ends");
        QCOMPARE(stage.at({0.3, 0.5}, "intersections")->kind->key, "intersections");
    }
    void objectsMayBeLeftOut()
    {
        const SnapStage stage(
            {lineFrom({0, 0}, {9, 0}), objectOf(app::EllipseRecipe{{30, 30}, {9, 9}})});
        const auto at = [&](Point pointer, app::ObjectRanges without) {
            return stage.snapper.at({pointer, 3, app::SnapTo::All.without("page"), {}, without})
                .has_value();
        };
        QVERIFY(at({1, 1}, {}) && !at({1, 1}, {0}));
        QVERIFY(at({31, 31}, {}) && !at({31, 31}, {1}));
    }
    void hiddenObjectsAreNotFound()
    {
        app::Object hidden = objectOf(app::EllipseRecipe{{30, 30}, {2, 2}});
        hidden.hidden = true;
        const SnapStage stage({hidden, lineFrom({0, 0}, {1, 1})});
        QCOMPARE(stage.textAt({30, 30}, "ends middles centres on-path"), "nothing");
    }
    void followsTheDocument()
    {
        SnapStage stage({objectOf(app::EllipseRecipe{{30, 30}, {9, 9}})});
        QCOMPARE(stage.textAt({30, 31}, "centres"), "30 30 centre");
        stage.document.load(
            SnapStage::documentOf({objectOf(app::EllipseRecipe{{60, 30}, {9, 9}})}, {}));
        QCOMPARE(stage.textAt({30, 31}, "centres"), "nothing");
        QCOMPARE(stage.textAt({60, 31}, "centres"), "60 30 centre");
    }
    // Whatever is found is within the radius, and really there.
    void whatIsFoundIsNearAndReallyThere()
    {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> place(0, 100);
        const auto point = [&] { return Point(place(random), place(random)); };
        std::vector<clipping::Segment> lines;
        std::vector<app::Object> objects;
        for (int i = 0; i < 60; ++i) {
            lines.push_back({point(), point()});
            objects.push_back(lineFrom(lines.back().a, lines.back().b));
        }
        const SnapStage stage(objects);
        std::map<std::string_view, int> found;
        for (int round = 0; round < 6000; ++round) {
            const Point pointer = point(), from = point();
            const auto& kind = app::snapKinds()[std::size_t(round) % app::snapKinds().size()];
            const auto snap =
                stage.snapper.at({pointer, 2, app::SnapTo::Nothing.with(kind.key), from});
            if (!snap)
                continue;
            ++found[kind.key];
            QCOMPARE(snap->kind, &kind);
            QVERIFY(glm::distance(snap->point, pointer) <= 2);
            const auto through = std::ranges::count_if(lines, [&](const auto& line) {
                return glm::distance(app::nearestOn(line, snap->point), snap->point) < 1e-9;
            });
            if (kind.key == "intersections")
                QVERIFY(through >= 2);
            else if (kind.key == "axes")
                QVERIFY(snap->point.x == from.x || snap->point.y == from.y);
            else if (kind.key != "page")
                QVERIFY(through >= 1);
            const auto isEnd = [&](const auto& line) {
                return line.a == snap->point || line.b == snap->point;
            };
            QVERIFY(kind.key != "ends" || std::ranges::any_of(lines, isEnd));
        }
        for (const char* key : {"ends", "middles", "intersections", "perpendicular", "on-path"})
            QVERIFY2(found[key] > 10, key);
    }
    // 100,000 lines through one point: too many to look at all of them.
    void aCrowdIsBounded()
    {
        std::vector<app::Object> objects;
        for (int i = 0; i < 100'000; ++i)
            objects.push_back(lineFrom({10, 10}, {10 + i * 1e-4, 20}));
        const SnapStage stage(objects);
        QCOMPARE(stage.picking.near({10, 10}, 3, app::NearLimits{1000}).size(), std::size_t(1000));
        QCOMPARE(stage.textAt({10.5, 10.5}, "ends intersections on-path"), "10 10 end");
    }
};

} // namespace view_snapping_snapper_test

TEST_CLASS(view_snapping_snapper_test::SnapperTest, None)
#include "tests/app/view/snapping/snapper_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include <glm/geometric.hpp>

#include <random>

#include "tests/app/view/snapping/snap_stage.h"
#include "tests/test_class.h"

namespace view_snapping_moved_test {

using app::OwnPoints;
using app::Point;

// Things that are moved as a whole.
class MovedTest : public QObject {
    Q_OBJECT

    static app::SnapQuery query(const char* kind)
    {
        return {.pointer = {},
                .radius = 3,
                .to = app::SnapTo::Nothing.with(kind),
                .seen = clipping::Window{{-999, -999}, {999, 999}}};
    }
    static bool has(const OwnPoints& own, const Point& point)
    {
        return std::ranges::find(own.points, point) != own.points.end();
    }

private slots:
    void aBoxHasCornersMiddlesAndACentre()
    {
        const auto own = app::ownPointsOf({{10, 20}, {30, 60}});
        QCOMPARE(own.points.size(), std::size_t(9));
        for (const Point& point :
             {Point(10, 20), Point(30, 60), Point(20, 40), Point(20, 20), Point(10, 40)})
            QVERIFY(has(own, point));
    }
    void objectsHaveTheirEndsAndMiddles()
    {
        app::Subpath curve{{50, 50}, {}, false};
        curve.segments.push_back({{60, 50}, {50, 60}, {60, 60}, true});
        const SnapStage stage(
            {lineFrom({0, 0}, {10, 30}), objectOf(curve), lineFrom({7, 7}, {9, 9})});
        const auto own = app::ownPointsOf(stage.document.now(), stage.scene.lines(), {0, 1},
                                          {{0, 0}, {60, 57.5}}, {0, 0});
        for (const Point& point : {Point(0, 0), Point(10, 30), Point(5, 15), Point(50, 50),
                                   Point(60, 50), Point(55, 57.5), Point(30, 28.75)})
            QVERIFY(has(own, point));
        QVERIFY(!has(own, {7, 7}));
    }
    void ofTooManyThoseNearestToTheHandCount()
    {
        app::Subpath stroke{{0, 0}, {}, false};
        for (int i = 1; i < 1000; ++i)
            stroke.segments.push_back({{double(i), 0}});
        const SnapStage stage({objectOf(stroke)});
        const auto own = app::ownPointsOf(stage.document.now(), stage.scene.lines(), {0},
                                          {{0, 0}, {999, 0}}, {500, 0});
        QCOMPARE(own.points.size(), OwnPoints::most);
        QVERIFY(has(own, {500, 0}) && has(own, {510, 0}) && !has(own, {600, 0}));
    }
    void aCornerSnapsWhereverTheThingWasGrabbed()
    {
        const SnapStage stage({lineFrom({100, 100}, {200, 130})});
        const auto own = app::ownPointsOf({{0, 0}, {20, 10}});
        const auto moved = stage.snapper.moved(own, {81.5, 88}, query("ends"));
        QCOMPARE(moved.by, Point(80, 90)); // its lower right corner
        QVERIFY(moved.place && moved.place->point == Point(100, 100));
        QCOMPARE(stage.snapper.moved(own, {70, 88}, query("ends")).by, Point(70, 88));
    }
    void itDoesNotSnapToItself()
    {
        const SnapStage stage({lineFrom({0, 0}, {20, 10})});
        const auto own = app::ownPointsOf({{0, 0}, {20, 10}});
        app::SnapQuery asked = query("ends");
        QVERIFY(stage.snapper.moved(own, {1, 1}, asked).place);
        asked.without = {0};
        QVERIFY(!stage.snapper.moved(own, {1, 1}, asked).place);
    }
    void edgesAreAlignedWithThoseOfObjects()
    {
        const SnapStage stage({lineFrom({100, 300}, {140, 320})});
        const auto own = app::ownPointsOf({{0, 0}, {20, 10}});
        const auto moved = stage.snapper.moved(own, {122, 50}, query("alignment"));
        QCOMPARE(moved.by, Point(120, 50));
        QCOMPARE(moved.lines.size(), std::size_t(1));
        QCOMPARE(moved.lines[0].at, 120.0); // left edge and middle
        app::SnapQuery elsewhere = query("alignment");
        elsewhere.seen = clipping::Window{{0, 0}, {90, 90}}; // without the line
        QVERIFY(stage.snapper.moved(own, {122, 50}, elsewhere).lines.empty());
    }
    void middlesAreAlignedWithThePageIfItIsAskedFor()
    {
        const SnapStage stage({});
        const auto own = app::ownPointsOf({{0, 0}, {20, 10}});
        app::SnapQuery asked = query("alignment");
        QCOMPARE(stage.snapper.moved(own, {137, 50}, asked).by, Point(137, 50));
        asked.to = asked.to.with("page");
        const auto moved = stage.snapper.moved(own, {137, 50}, asked); // the middle is at 148.5
        QCOMPARE(moved.by, Point(138.5, 50));
        QCOMPARE(moved.lines.size(), std::size_t(1));
    }
    void theGridDecidesTheAxisThatIsNotAligned()
    {
        const SnapStage stage({lineFrom({101, 300}, {301, 320})});
        const auto own = app::ownPointsOf({{0, 0}, {20, 11}});
        app::SnapQuery asked = query("alignment");
        asked.to = asked.to.with("grid");
        asked.grid = app::GridPoints{{0, 0}, {10, 0}, {0, 10}};
        QCOMPARE(stage.snapper.moved(own, {62, 52}, asked).by, Point(60, 50));
        QCOMPARE(stage.snapper.moved(own, {102, 52}, asked).by, Point(101, 50));
    }
    void thePointerIsAlignedTooWhereNothingIsNear()
    {
        const SnapStage stage({lineFrom({100, 300}, {140, 320})});
        app::SnapQuery asked = query("drawn-alignment");
        asked.pointer = {101, 50};
        const auto snap = stage.snapper.at(asked);
        QVERIFY(snap && snap->point == Point(100, 50) && snap->lines.size() == 1);
        asked.pointer = {101, 301};
        asked.to = asked.to.with("ends");
        QCOMPARE(stage.snapper.at(asked)->kind->key, "ends");
    }
    void nothingMovesFartherThanTheRadius()
    {
        std::mt19937_64 random(4);
        std::uniform_real_distribution<double> place(0, 100);
        const auto point = [&] { return Point(place(random), place(random)); };
        std::vector<app::Object> objects;
        for (int i = 0; i < 40; ++i)
            objects.push_back(lineFrom(point(), point()));
        const SnapStage stage(objects);
        const auto own = app::ownPointsOf({{0, 0}, {7, 5}});
        app::SnapQuery asked = query("ends");
        asked.to = app::SnapTo::All;
        int snapped = 0;
        for (int round = 0; round < 500; ++round) {
            const Point by = point();
            const auto moved = stage.snapper.moved(own, by, asked);
            QVERIFY(std::abs(moved.by.x - by.x) <= 3.0001 && std::abs(moved.by.y - by.y) <= 3.0001);
            if (!moved.place)
                continue;
            ++snapped;
            QVERIFY(std::ranges::any_of(own.points, [&](const Point& p) {
                return glm::distance(p + moved.by, moved.place->point) < 1e-9;
            }));
        }
        QVERIFY(snapped > 50);
    }
};

} // namespace view_snapping_moved_test

TEST_CLASS(view_snapping_moved_test::MovedTest, None)
#include "tests/app/view/snapping/moved_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Places by which clip windows snap, and at which they are snapped to.
#include "app/session/window_kinds.h"
#include "app/view/snapping/window_points.h"

#include <glm/geometric.hpp>

#include <numbers>

#include "tests/app/view/snapping/snap_stage.h"
#include "tests/test_class.h"

namespace view_snapping_window_points_test {

using app::Point;

namespace {

bool has(const app::OwnPoints& own, const Point& point)
{
    return std::ranges::any_of(
        own.points, [&](const Point& p) { return glm::distance(p, point) < 1e-9; });
}

const app::WindowShape circle = app::windowKind("ellipse").make({{40, 40}, {60, 60}});

} // namespace

class WindowPointsTest : public QObject {
    Q_OBJECT

private slots:
    void aRotatedRectangleHasItsRealCorners()
    {
        const double half = 10 * std::numbers::sqrt2;
        const auto own = app::ownPointsOf(
            app::RectangleShape{{{40, 40}, {60, 60}}, std::numbers::pi / 4});
        for (const Point& p : {Point(50 + half, 50), {50, 50 - half}, {50, 50}})
            QVERIFY(has(own, p));
        QVERIFY(!has(own, {40, 40}));
        QVERIFY(std::abs(own.bounds.max.x - 50 - half) < 1e-9);
    }
    void anEllipseHasItsCentreAndOutermostPoints()
    {
        const auto own = app::ownPointsOf(circle);
        QCOMPARE(own.points.size(), 5u);
        for (const Point& p : {Point(40, 50), {60, 50}, {50, 40}, {50, 60}, {50, 50}})
            QVERIFY(has(own, p));
    }
    void aStarHasItsCorners()
    {
        const auto star = app::windowKind("star").make({{0, 0}, {20, 20}});
        const auto own = app::ownPointsOf(star);
        QCOMPARE(own.points.size(), 10u);
        QVERIFY(has(own, {10, 0}));
    }
    void anEllipseIsSnappedTo()
    {
        const SnapStage stage({}, {{{.shape = circle}}});
        QCOMPARE(stage.textAt({51, 51}, "centres window"), "50 50 centre");
        QCOMPARE(stage.textAt({39, 51}, "centres window"), "40 50 window edge");
        QCOMPARE(stage.textAt({44, 44}, "centres window"), "nothing");
    }
    void aRotatedRectangleIsSnappedToButNotTheDraggedOne()
    {
        const app::RectangleShape turned{{{40, 40}, {60, 60}}, std::numbers::pi / 4};
        const SnapStage stage({}, {{{.shape = circle}, {.shape = turned}}});
        const Point top(50, 50 - 10 * std::numbers::sqrt2);
        app::SnapQuery query{top + Point(1, -0.5), 3, app::SnapTo::Nothing.with("window")};
        const auto snap = stage.snapper.at(query);
        QVERIFY(snap && glm::distance(snap->point, top) < 1e-9);
        query.withoutWindow = 1;
        QVERIFY(!stage.snapper.at(query));
    }
};

} // namespace view_snapping_window_points_test

TEST_CLASS(view_snapping_window_points_test::WindowPointsTest, Core)
#include "tests/app/view/snapping/window_points_test.moc"

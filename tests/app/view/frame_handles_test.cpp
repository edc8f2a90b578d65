// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/window_outline.h"
#include "app/view/area_at.h"
#include "app/view/frame_handles.h"

#include <QTest>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

#include "tests/test_class.h"

namespace view_frame_handles_test {

using namespace app;

namespace {

// One pixel is one unit; the point (100, 100) is in the middle.
View unitView()
{
    View view;
    view.size = {200, 200};
    view.centre = {100, 100};
    view.zoom = 1;
    return view;
}

const WindowFrame unrotated{{{40, 60}, {160, 140}}};
const WindowFrame quarter{{{40, 60}, {160, 140}}, glm::radians(90.0)}; // (60, 40)-(140, 160)

} // namespace

class FrameHandlesTest : public QObject {
    Q_OBJECT

private slots:
    void handlesFollowTheRotation()
    {
        QCOMPARE(placedHandles(unrotated, unitView()).size(), 9u);
        QCOMPARE(handleAt({100, 32}, unrotated, unitView()), std::optional(rotationHandle));
        QCOMPARE(handleAt({160, 100}, unrotated, unitView()), (std::optional(Handle{1, 0})));
        // A quarter turn from x towards y takes the upper side to the right.
        QCOMPARE(handleAt({168, 100}, quarter, unitView()), std::optional(rotationHandle));
        QCOMPARE(handleAt({100, 160}, quarter, unitView()), (std::optional(Handle{1, 0})));
        QCOMPARE(handleAt({160, 100}, quarter, unitView()), std::optional(rotationHandle));
        QCOMPARE(handleAt({100, 100}, quarter, unitView()), std::nullopt);
    }
    void aDraggedHandleMovesItsSideAlone()
    {
        const auto wide =
            dragged(quarter, {1, 0}, {100, 160}, {117, 170}, Proportion::Free, Anchor::Opposite);
        QVERIFY(std::abs(wide.box.max.x - wide.box.min.x - 130) < 1e-9);
        QVERIFY(std::abs(wide.box.max.y - wide.box.min.y - 80) < 1e-9);
        const auto corners = cornersOf(wide), before = cornersOf(quarter);
        QVERIFY(glm::distance(corners[0], before[0]) < 1e-9);
        QVERIFY(glm::distance(corners[3], before[3]) < 1e-9);
    }
    void theRotationHandleTurnsAboutTheCentre()
    {
        const auto free = dragged(unrotated, rotationHandle, {100, 30}, {170, 100},
                                  Proportion::Free, Anchor::Opposite);
        QVERIFY(free.box == unrotated.box);
        QVERIFY(std::abs(free.angle - glm::radians(90.0)) < 1e-12);
        const auto step = dragged(unrotated, rotationHandle, {100, 30}, {112, 32}, Proportion::Kept,
                                  Anchor::Opposite); // 10°: the nearest step is 15°
        QVERIFY(std::abs(step.angle - glm::radians(15.0)) < 1e-12);
        const auto back =
            dragged(step, rotationHandle, {100, 30}, {82, 32}, Proportion::Kept, Anchor::Opposite);
        QCOMPARE(back.angle, 0.0); // axis-aligned again, for every algorithm
    }
    void theWindowUnderThePointer()
    {
        const Subpath outer{{0, 0}, {{{100, 0}}, {{100, 100}}, {{0, 100}}}, true};
        const Subpath hole{{40, 40}, {{{60, 40}}, {{60, 60}}, {{40, 60}}}, true};
        const PathShape ring{Path(std::vector{outer, hole}), FillRule::EvenOdd};
        QVERIFY(isAt(ring, {20, 20}, 1));
        QVERIFY(!isAt(ring, {50, 50}, 1));
        QVERIFY(isAt(ring, {50, 41}, 2));                 // near its border
        QVERIFY(isAt(PathShape{ring.path}, {50, 50}, 1)); // nonzero: no hole
        QVERIFY(!isAt(ring, {102, 50}, 1) && isAt(ring, {101, 50}, 2));
        const ClipWindows windows{{{.shape = ring},
                                   {.shape = RectangleShape{{{0, 0}, {50, 50}}}},
                                   {.shape = RectangleShape{{{0, 0}, {9, 9}}}, .visible = false}}};
        QCOMPARE(windowAt(windows, {5, 5}, 0.5), std::optional<std::size_t>(1));
        QCOMPARE(windowAt(windows, {80, 80}, 0.5), std::optional<std::size_t>(0));
        QCOMPARE(windowAt(windows, {55, 55}, 0.5), std::nullopt);
    }
};

} // namespace view_frame_handles_test

TEST_CLASS(view_frame_handles_test::FrameHandlesTest, None)
#include "tests/app/view/frame_handles_test.moc"

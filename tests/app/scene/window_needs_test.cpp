// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/area_windows.h"
#include "app/scene/window_needs.h"
#include "clipping/region/catalogue.h"

#include <QTest>

#include "tests/app/scene/mixed_windows.h"
#include "tests/test_class.h"

namespace scene_window_needs_test {

using namespace app;
using clipping::Form;

namespace {

ClipRegion regionOf(std::initializer_list<WindowShape> shapes)
{
    ClipWindows windows;
    for (const WindowShape& shape : shapes)
        windows.list.push_back({.shape = shape});
    return app::regionOf(windows, 0.1);
}

const WindowShape upright = RectangleShape{{{0, 0}, {9, 9}}};
const WindowShape rotated = RectangleShape{{{0, 0}, {9, 9}}, 0.5};
const WindowShape hexagon = shapeOf(StarRecipe{{5, 5}, 5, 0, 0, 6});
const WindowShape star = shapeOf(StarRecipe{{5, 5}, 5, 2, 0, 5});

} // namespace

class WindowNeedsTest : public QObject {
    Q_OBJECT

private slots:
    void aShapeSaysWhatItNeeds()
    {
        QCOMPARE(needsOf(regionOf({})), WindowNeeds::Rectangle);
        QCOMPARE(needsOf(regionOf({upright})), WindowNeeds::Rectangle);
        QCOMPARE(needsOf(regionOf({rotated})), WindowNeeds::RotatedRectangle);
        QCOMPARE(needsOf(regionOf({hexagon})), WindowNeeds::ConvexPolygon);
        QCOMPARE(needsOf(regionOf({star})), WindowNeeds::AnyArea);
        QCOMPARE(needsOf(regionOf({star, upright, hexagon})), WindowNeeds::AnyArea);
        QCOMPARE(needsOf(regionOf({rotated, upright})), WindowNeeds::RotatedRectangle);
    }
    void rowsCanClipWhatTheirFormsAllow()
    {
        for (const auto& row : clipping::algorithms()) {
            const bool areas = clipping::findRegionAlgorithm(row.key);
            QVERIFY(canClip(row, WindowNeeds::Rectangle)
                    && canClip(row, WindowNeeds::RotatedRectangle));
            QCOMPARE(canClip(row, WindowNeeds::ConvexPolygon), row.polygon || areas);
            QCOMPARE(canClip(row, WindowNeeds::AnyArea), areas);
        }
        const auto* lb = clipping::findAlgorithm("lb");
        const auto* cb = clipping::findAlgorithm("cb");
        QCOMPARE(limitText(*lb, WindowNeeds::ConvexPolygon), "rectangles only");
        QCOMPARE(limitText(*cb, WindowNeeds::AnyArea), "convex only");
        QCOMPARE(limitText(*cb, WindowNeeds::ConvexPolygon), "");
        QCOMPARE(limitText(clipping::exactAlgorithm(), WindowNeeds::AnyArea), "");
    }
    void whatIsUsedInstead()
    {
        const auto* lb = clipping::findAlgorithm("lb");
        const auto* cb = clipping::findAlgorithm("cb");
        const Variant exact{&clipping::exactAlgorithm()};
        const Variant published{cb, Form::Published};
        QCOMPARE(usedAt(regionOf({rotated}), published), published);
        QCOMPARE(usedAt(regionOf({hexagon}), published), Variant{cb});
        QCOMPARE(usedAt(regionOf({hexagon, rotated}), Variant{lb}), exact);
        QCOMPARE(usedAt(regionOf({star}), Variant{cb}), exact);
        QCOMPARE(usedAt(regionOf({}), Variant{lb}), Variant{lb});
    }
    void headingsNameTheShape()
    {
        const auto text = [](const WindowShape& shape) {
            return shapeText(regionOf({shape}).steps[0]);
        };
        QCOMPARE(text(upright), "rectangle");
        QCOMPARE(text(rotated), "rotated rectangle");
        QCOMPARE(text(hexagon), "convex, 6 edges");
        QCOMPARE(text(star), "concave, 10 edges");
    }
    void convexIsDecidedExactly()
    {
        const auto corners = [](std::vector<Point> ring) {
            return convexPolygonOf({std::move(ring)}).corners.size();
        };
        QCOMPARE(corners({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), 4u);
        QCOMPARE(corners({{0, 4}, {4, 4}, {4, 0}, {0, 0}}), 4u); // the other way round
        QCOMPARE(corners({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 4}}),
                 6u); // on an edge, twice
        QCOMPARE(corners({{0, 0}, {4, 0}, {2, 1e-300}, {4, 4}}), 0u);
        QCOMPARE(corners({{0, 0}, {4, 4}, {2, 2}}), 0u); // no area
        QCOMPARE(corners({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}), 0u);
        QCOMPARE(corners({{0, 0}, {4, 0}}), 0u);
        QCOMPARE(convexPolygonOf({}).corners.size(), 0u);
        const std::vector<Point> ring{{0, 0}, {4, 0}, {4, 4}};
        QCOMPARE(convexPolygonOf({ring, ring}).corners.size(), 0u);
    }
};

} // namespace scene_window_needs_test

TEST_CLASS(scene_window_needs_test::WindowNeedsTest, None)
#include "tests/app/scene/window_needs_test.moc"

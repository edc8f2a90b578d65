// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recipe_outline.h"
#include "app/scene/area_windows.h"

#include <QTest>

#include <cmath>
#include <numbers>

#include "tests/test_class.h"

namespace scene_united_windows_test {

using namespace app;

namespace {

ClipWindow box(double x0, double y0, double x1, double y1)
{
    return {.shape = RectangleShape{{{x0, y0}, {x1, y1}}}};
}

double areaOf(const PathShape& shape)
{
    double twice = 0;
    for (const Subpath& path : shape.path.subpaths()) {
        Point last = path.start;
        const auto add = [&](const Point& p) {
            twice += last.x * p.y - last.y * p.x;
            last = p;
        };
        for (const PathSegment& segment : path.segments)
            add(segment.to);
        add(path.start);
    }
    return twice / 2;
}

} // namespace

class UnitedWindowsTest : public QObject {
    Q_OBJECT

private slots:
    void rectanglesBecomeOnePath()
    {
        const std::vector two{box(0, 0, 4, 4), box(2, 2, 6, 6)};
        QCOMPARE(areaOf(united(two, {})), 28.0);
        QCOMPARE(united(two, {}).path.subpathCount(), 1u);
        const std::vector apart{box(0, 0, 4, 4), box(5, 5, 6, 6)};
        QCOMPARE(areaOf(united(apart, {})), 17.0);
        const std::vector touching{box(0, 0, 4, 4), box(4, 0, 6, 4)};
        QCOMPARE(areaOf(united(touching, {})), 24.0);
        QCOMPARE(united(touching, {}).path.subpathCount(), 1u);
    }

    void operationsDoNotCount()
    {
        std::vector two{box(0, 0, 4, 4), box(2, 2, 6, 6)};
        two[1].operation = WindowOperation::CutOut;
        QCOMPARE(areaOf(united(two, {})), 28.0);
    }

    void curvesAreInscribed()
    {
        const auto circle = outlineOf(EllipseRecipe{{0, 0}, Point(10)});
        const std::vector one{ClipWindow{.shape = PathShape{Path({&*circle, 1})}}, box(0, 0, 1, 1)};
        const double area = areaOf(united(one, {}));
        QVERIFY(area < 100 * std::numbers::pi && area > 99.5 * std::numbers::pi);
    }

    void nothingIsNothing()
    {
        const std::vector none{box(0, 0, 0, 4), ClipWindow{.shape = PathShape{}}};
        QVERIFY(united(none, {}).path.subpaths().empty());
    }
};

} // namespace scene_united_windows_test

TEST_CLASS(scene_united_windows_test::UnitedWindowsTest, Core)
#include "tests/app/scene/united_windows_test.moc"

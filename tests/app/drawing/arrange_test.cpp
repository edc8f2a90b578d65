// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/arrange.h"

#include <QTest>

#include <glm/geometric.hpp>

#include "tests/test_class.h"

namespace drawing_arrange_test {

using namespace app;
using clipping::Window;

class ArrangeTest : public QObject {
    Q_OBJECT

    static Window at(const Window& box, const Point& way) { return {box.min + way, box.max + way}; }

private slots:
    void sidesAndMiddlesMeet()
    {
        const std::vector<Window> boxes{{{0, 0}, {10, 4}}, {{7, 9}, {8, 29}}, {{-5, 1}, {3, 2}}};
        const Window to{{100, 200}, {150, 300}};
        const auto each = [&](int axis, AlignTo side, double expected, const auto& place) {
            const auto ways = aligned(boxes, to, axis, side);
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                QCOMPARE(place(at(boxes[i], ways[i])), expected);
                QCOMPARE(ways[i][1 - axis], 0.0);
            }
        };
        each(0, AlignTo::Least, 100, [](const Window& w) { return w.min.x; });
        each(0, AlignTo::Most, 150, [](const Window& w) { return w.max.x; });
        each(0, AlignTo::Middle, 125, [](const Window& w) { return (w.min.x + w.max.x) / 2; });
        each(1, AlignTo::Least, 200, [](const Window& w) { return w.min.y; });
        each(1, AlignTo::Most, 300, [](const Window& w) { return w.max.y; });
    }
    void spreadBoxesHaveEqualGapsAndTheOuterOnesStay()
    {
        const std::vector<Window> boxes{
            {{50, 0}, {60, 1}}, {{0, 0}, {10, 1}}, {{12, 0}, {32, 1}}, {{20, 0}, {30, 1}}};
        const auto ways = spread(boxes, 0);
        QCOMPARE(ways[0], Point(0, 0));
        QCOMPARE(ways[1], Point(0, 0));
        // 60 long, 50 covered: gaps of 10/3
        const double gap = 10.0 / 3;
        QVERIFY(std::abs(at(boxes[2], ways[2]).min.x - (10 + gap)) < 1e-12);
        QVERIFY(std::abs(at(boxes[3], ways[3]).min.x - (30 + 2 * gap)) < 1e-12);
        QCOMPARE(spread(std::span(boxes).first(2), 0), (std::vector{Point(0, 0), Point(0, 0)}));
        const std::vector<clipping::Window> two{{{5, 0}, {7, 1}}, {{20, 0}, {21, 1}}};
        QCOMPARE(spread(two, 0, clipping::Window{{0, 0}, {100, 9}}),
                 (std::vector{Point(-5, 0), Point(79, 0)})); // to the sides of the extent
    }
    void sameSizeKeepsTheTopLeftCorner()
    {
        const std::vector<Window> boxes{{{1, 2}, {5, 4}}, {{3, 3}, {3, 9}}};
        const auto maps = sameSize(boxes, {{0, 0}, {8, 8}}, true, false);
        QCOMPARE(maps[0](Point(1, 2)), Point(1, 2));
        QCOMPARE(maps[0](Point(5, 4)), Point(9, 4));
        QCOMPARE(maps[1](Point(3, 9)), Point(3, 9)); // no width to scale
    }
    void gridsAndCirclesLeaveOutTheOriginal()
    {
        const auto cells = grid(4, 5, {10, 20});
        QCOMPARE(cells.size(), std::size_t(19));
        QCOMPARE(cells.front()(Point(1, 1)), Point(11, 1));
        QCOMPARE(cells.back()(Point(1, 1)), Point(41, 61));
        const auto teeth = circle(24, 360, {0, 0});
        QCOMPARE(teeth.size(), std::size_t(23));
        QVERIFY(glm::distance(teeth[5](Point(8, 0)), Point(0, -8)) < 1e-12);
        const auto fan = circle(3, 90, {0, 0});
        QVERIFY(glm::distance(fan.back()(Point(8, 0)), Point(0, -8)) < 1e-12);
        QVERIFY(grid(1, 1, {1, 1}).empty() && circle(1, 360, {}).empty());
    }
};

} // namespace drawing_arrange_test

TEST_CLASS(drawing_arrange_test::ArrangeTest, None)
#include "tests/app/drawing/arrange_test.moc"

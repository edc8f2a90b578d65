// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/box_in_outline.h"
#include "app/scene/region.h"

#include <QTest>

#include <glm/common.hpp>

#include <array>

#include "tests/app/scene/mixed_windows.h"

using namespace app;

class BoxInOutlineTest : public QObject {
    Q_OBJECT

private slots:
    void whatABoxSaysIsTrueOfTheLinesInIt()
    {
        MixedWindows random(1);
        std::array<int, 3> decided{};
        for (int round = 0; round < 300; ++round) {
            const ClipRegion region = regionOf(random.windows(1, Mixed::Any), 0.1);
            const auto& step = region.steps[0];
            if (step.rings.empty())
                continue;
            const clipping::PreparedRegion area(
                {{areasOf(region).steps[0]}, clipping::Keep::Inside});
            for (int i = 0; i < 30; ++i) {
                const Point p = random.point(),
                            q = p + Point(random.number(0, 9), random.number(0, 9));
                const Share share = shareOfBox(step.rings, step.rule, {p, q});
                ++decided[std::size_t(share)];
                for (int n = 0; n < 5 && share != Share::Some; ++n) {
                    const auto in = [&] {
                        return Point(random.number(p.x, q.x), random.number(p.y, q.y));
                    };
                    const clipping::Segment line{in(), in()};
                    const auto kept = clipping::clip(line, area);
                    QVERIFY(share == Share::None ? kept.empty()
                                                 : kept.size() == 1 && kept[0].segment == line);
                }
            }
        }
        for (const int count : decided)
            QVERIFY2(count > 100, qPrintable(QString::number(count)));
    }
    void boxesOnTheBorderAreNotDecided()
    {
        const std::vector<std::vector<Point>> ring{{{0, 0}, {4, 4}, {-4, 4}}};
        const auto share = [&](const clipping::Window& box) {
            return shareOfBox(ring, FillRule::NonZero, box);
        };
        QCOMPARE(share({{1, 1}, {2, 1}}), Share::Some); // a corner touches an edge
        QCOMPARE(share({{0, 0}, {0, 0}}), Share::Some);
        QCOMPARE(share({{2, 0}, {3, 1}}), Share::None);
        QCOMPARE(share({{-1, 2}, {1, 3}}), Share::All);
        QCOMPARE(share({{-9, -9}, {9, 9}}), Share::Some); // around all of it
        const std::vector<std::vector<Point>> large{std::vector<Point>(mostEdgesForBoxes + 1)};
        QCOMPARE(shareOfBox(large, FillRule::NonZero, {{5, 5}, {6, 6}}), Share::Some);
    }
};

QTEST_APPLESS_MAIN(BoxInOutlineTest)
#include "box_in_outline_test.moc"

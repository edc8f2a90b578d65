// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/alignment.h"

#include <QTest>

#include "tests/test_class.h"

namespace view_snapping_alignment_test {

using app::Point;
using clipping::Window;

class AlignmentTest : public QObject {
    Q_OBJECT

private slots:
    void edgesAndMiddlesAreAligned_data()
    {
        QTest::addColumn<Window>("box");
        QTest::addColumn<Point>("by");
        const auto row = [](const char* name, Window box, Point by) {
            QTest::newRow(name) << box << by;
        };
        // The other box is 100 to 140, 200 to 220.
        row("left", {{101, 20}, {155, 30}}, {-1, 0});
        row("right", {{80, 20}, {142, 30}}, {-2, 0});
        row("middle", {{105, 20}, {134, 30}}, {0.5, 0});
        row("left beside right", {{139, 20}, {190, 30}}, {1, 0});
        row("top", {{300, 202}, {310, 260}}, {0, -2});
        row("both", {{99, 222}, {192, 290}}, {1, -2});
        row("a point", {{121, 50}, {121, 50}}, {-1, 0});
        row("too far", {{104, 20}, {183, 30}}, {0, 0});
    }
    void edgesAndMiddlesAreAligned()
    {
        QFETCH(Window, box);
        const Window other{{100, 200}, {140, 220}};
        const auto alignment = app::align(box, std::span(&other, 1), 3);
        QTEST(alignment.by, "by");
        QCOMPARE(alignment.lines.size(),
                 std::size_t((alignment.by.x != 0) + (alignment.by.y != 0)));
    }
    void theLineLeadsToTheNearestOfThoseAligned()
    {
        const std::vector<Window> others{{{100, 900}, {110, 910}}, {{100, 200}, {140, 220}}};
        const auto alignment = app::align({{101, 20}, {155, 30}}, others, 3);
        const app::AlignmentLine expected{0, 100, 20, 220, 30, 200};
        QCOMPARE(alignment.lines, std::vector{expected});
    }
    void boxesThatOverlapHaveNoGap()
    {
        const Window other{{100, 200}, {140, 220}};
        const auto lines = app::align({{101, 214}, {155, 250}}, std::span(&other, 1), 3).lines;
        QCOMPARE(lines.size(), std::size_t(1));
        QVERIFY(!lines[0].gapFrom && !lines[0].gapTo);
        QCOMPARE(lines[0].to, 250.0);
    }
    void nothingIsMovedFartherThanTheRadius()
    {
        QVERIFY(app::align({{0, 0}, {9, 9}}, {}, 3).lines.empty());
        const Window other{{3.001, 12.001}, {300, 300}};
        QVERIFY(app::align({{0, 0}, {0, 9}}, std::span(&other, 1), 3).lines.empty());
    }
};

} // namespace view_snapping_alignment_test

TEST_CLASS(view_snapping_alignment_test::AlignmentTest, None)
#include "tests/app/view/snapping/alignment_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/fixed_parts.h"

#include <QTest>

#include "tests/test_class.h"

namespace nodes_fixed_parts_test {

class FixedPartsTest : public QObject {
    Q_OBJECT

    static app::NodeSubpath square()
    {
        return app::nodesOf(
            std::vector<app::Subpath>{{{0, 0}, {{{10, 0}}, {{10, 10}}, {{0, 10}}}, true}})[0];
    }

private slots:
    void segmentsOfAMovedNodeAreLeftOut()
    {
        app::NodeSubpath moved = square();
        moved.nodes[1].at = {12, 3};
        const auto parts = app::fixedParts(square(), moved);
        QCOMPARE(parts.size(), std::size_t(2));
        QCOMPARE(parts[0].start, app::Point(10, 10));
        QCOMPARE(parts[0].segments[0].to, app::Point(0, 10));
        QCOMPARE(parts[1].segments[0].to, app::Point(0, 0)); // the closing segment
    }
    void aNodeBetweenMovedOnesStaysAPoint()
    {
        app::NodeSubpath moved = square();
        moved.nodes[0].at = {1, 1};
        moved.nodes[2].at = {12, 12};
        const auto parts = app::fixedParts(square(), moved);
        QCOMPARE(parts.size(), std::size_t(2));
        QCOMPARE(parts[0].start, app::Point(10, 0));
        QCOMPARE(parts[0].segments[0].to, app::Point(10, 0));
    }
    void aMovedHandleLeavesBothNodesOfItsCurve()
    {
        const auto curve = app::nodesOf(
            std::vector<app::Subpath>{{{0, 0}, {{{10, 0}, {0, 5}, {10, 5}, true}}, false}})[0];
        app::NodeSubpath moved = curve;
        moved.nodes[0].out = {3, 7};
        QCOMPARE(app::fixedParts(curve, moved).size(), std::size_t(2));
        QCOMPARE(app::fixedParts(curve, curve).size(), std::size_t(1));
        QVERIFY(app::fixedParts(curve, curve)[0].segments[0].curved);
    }
};

} // namespace nodes_fixed_parts_test

TEST_CLASS(nodes_fixed_parts_test::FixedPartsTest, None)
#include "tests/app/nodes/fixed_parts_test.moc"

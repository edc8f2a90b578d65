// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_types.h"

#include <QTest>

#include "tests/app/nodes/shapes.h"
#include "tests/test_class.h"

namespace nodes_node_path_test {

class NodePathTest : public QObject {
    Q_OBJECT

private slots:
    void comesBackWithTheSameNumbers()
    {
        const std::vector<app::Subpath> paths{
            wave(),
            circle(10),
            {{1, 2}, {{{3, 4}}, {{5, 6}}}, true},
            {{1, 2}, {{{3, 4}}, {{5, 6}}, {{0, 6}, {5, 7}, {1, 7}, true}}, true},
            {{1, 2}, {}, false},
            {{1, 2}, {}, true},
            {{1, 2}, {{{1, 2}}}, false},                       // two nodes on one spot
            {{1, 2}, {{{1, 2}, {5, 5}, {-5, 5}, true}}, true}, // a loop of one node
            {{1, 2}, {{{7, 2}, {1, 2}, {7, 2}, true}}, false}, // handles without length
        };
        const app::NodePath nodes = app::nodesOf(paths);
        QVERIFY(app::subpathsOf(nodes) == paths);
        QCOMPARE(nodes[1].nodes.size(), std::size_t(4));
        QCOMPARE(nodes[1].segmentCount(), std::size_t(4));
        QCOMPARE(nodes[7].nodes.size(), std::size_t(1));
        QCOMPARE(nodes[7].segmentCount(), std::size_t(1));
        QCOMPARE(nodes[5].segmentCount(), std::size_t(0));
        QCOMPARE(app::nodeCount(nodes), std::size_t(3 + 4 + 3 + 4 + 1 + 1 + 2 + 1 + 2));
    }
    void aClosingLineOfItsOwnIsNotKeptTwice()
    {
        const auto square = nodesOf({{0, 0}, {{{4, 0}}, {{4, 4}}, {{0, 0}}}, true});
        QCOMPARE(square.nodes.size(), std::size_t(3));
        QCOMPARE(square.segmentCount(), std::size_t(3));
    }
    void typesFollowFromTheHandles()
    {
        const auto types = [](const app::NodeSubpath& subpath) {
            std::vector<app::NodeType> all;
            for (const app::Node& node : subpath.nodes)
                all.push_back(node.type);
            return all;
        };
        using enum app::NodeType;
        QCOMPARE(types(nodesOf(circle(5))), std::vector(4, Symmetric));
        QCOMPARE(types(polyline({{0, 0}, {1, 0}, {2, 0}})), std::vector(3, Corner));
        QCOMPARE(
            types(nodesOf({{0, 0},
                           {{{10, 0}, {3, 5}, {8, 2}, true}, {{30, 0}, {14, -4}, {20, 9}, true}},
                           false})),
            (std::vector{Corner, Smooth, Corner}));
        QCOMPARE(types(nodesOf({{0, 0}, {{{10, 0}}, {{20, 9}, {15, 0}, {20, 4}, true}}, false})),
                 (std::vector{Corner, Smooth, Corner})); // in line with a straight segment
        QCOMPARE(types(nodesOf({{0, 0}, {{{10, 0}}, {{20, 9}, {15, 1}, {20, 4}, true}}, false})),
                 std::vector(3, Corner));
    }
    void knowsItsNeighboursAtOpenAndClosedEnds()
    {
        const auto open = polyline({{0, 0}, {1, 0}, {2, 5}});
        QVERIFY(!open.previous(0) && !open.next(2) && open.isEnd(0) && !open.isEnd(1));
        const auto closed = polyline({{0, 0}, {1, 0}, {2, 5}}, true);
        QVERIFY(closed.previous(0) == 2u && closed.next(2) == 0u && !closed.isEnd(0));
        const auto point = polyline({{0, 0}}, true);
        QVERIFY(point.isEnd(0));
    }
    void findsNumbersThatAreNotFinite()
    {
        app::NodePath path{nodesOf(wave())};
        QVERIFY(app::isFinite(path));
        path[0].nodes[1].out.y = NAN;
        QVERIFY(!app::isFinite(path));
    }
};

} // namespace nodes_node_path_test

TEST_CLASS(nodes_node_path_test::NodePathTest, None)
#include "tests/app/nodes/node_path_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_moves.h"

#include <QTest>

#include <limits>

#include "tests/app/nodes/shapes.h"
#include "tests/test_class.h"

namespace nodes_node_moves_test {

class NodeMovesTest : public QObject {
    Q_OBJECT

    using Side = app::HandleSide;

private slots:
    void handlesFollowTheirNode()
    {
        app::NodePath path{nodesOf(wave())};
        const app::NodePath before = path;
        path[0].nodes[1].selected = true;
        QVERIFY(app::moveSelected(path, {3, -4}));
        const app::Node& node = path[0].nodes[1];
        QCOMPARE(node.at, app::Point(63, -4));
        QCOMPARE(node.in, before[0].nodes[1].in + app::Point(3, -4));
        QCOMPARE(node.out, before[0].nodes[1].out + app::Point(3, -4));
        QCOMPARE(path[0].nodes[0], before[0].nodes[0]);
    }
    void landsExactlyWhereItShould()
    {
        app::NodePath path{polyline({{0.1, 0.7}, {1e7 / 3, 5}, {9, 9}})};
        path[0].nodes[1].selected = true;
        QVERIFY(app::moveSelectedTo(path, {0, 1}, {0.3, 0.1}));
        QCOMPARE(path[0].nodes[1].at, app::Point(0.3, 0.1));
        QCOMPARE(path[0].nodes[1].in, app::Point(0.3, 0.1)); // still straight
    }
    void refusesWhatIsNotFinite()
    {
        app::NodePath path{nodesOf(wave())};
        app::selectAll(path, true);
        const app::NodePath before = path;
        for (const double bad : {double(NAN), std::numeric_limits<double>::infinity()}) {
            QVERIFY(!app::moveSelected(path, {bad, 0}));
            QVERIFY(!app::moveSelectedTo(path, {0, 1}, {0, bad}));
            QVERIFY(!app::moveHandle(path[0], 1, Side::In, {bad, 0}));
            QVERIFY(!app::bendSegment(path[0], 0, 0.5, {0, bad}));
            QVERIFY(!app::bendSegment(path[0], 0, bad, {0, 1}));
        }
        QCOMPARE(path, before);
    }
    void aSmoothNodeTurnsItsOtherHandleAndASymmetricOneMirrorsIt()
    {
        app::NodeSubpath path = nodesOf(circle(10));
        const double long0 = glm::distance(path.nodes[1].in, path.nodes[1].at);
        QVERIFY(app::moveHandle(path, 1, Side::Out, {-6, 18}));
        QVERIFY(glm::distance(path.nodes[1].in, app::Point(6, 2)) < 1e-12);
        path.nodes[2].type = app::NodeType::Smooth;
        QVERIFY(app::moveHandle(path, 2, Side::In, {-14, 3}));
        const app::Node& node = path.nodes[2];
        QVERIFY(std::abs(glm::distance(node.out, node.at) - long0) < 1e-12);
        QVERIFY(
            std::abs(glm::distance(node.out, app::Point(-10, 0) + app::Point(4, -3) / 5.0 * long0))
            < 1e-12);
        path.nodes[3].type = app::NodeType::Corner;
        const app::Point in = path.nodes[3].in;
        QVERIFY(app::moveHandle(path, 3, Side::Out, {1, 1}));
        QCOMPARE(path.nodes[3].in, in);
    }
    void aStraightSegmentHasNoHandle()
    {
        app::NodeSubpath path = polyline({{0, 0}, {5, 0}});
        QVERIFY(!app::moveHandle(path, 0, Side::Out, {1, 1}));
        QVERIFY(!app::handleOf(path, 0, Side::Out));
        QVERIFY(!app::bendSegment(path, 0, 0.5, {1, 1}));
    }
    void besideALineASmoothHandleStaysInLine()
    {
        app::NodePath path{
            nodesOf({{0, 0}, {{{10, 0}}, {{20, 9}, {15, 0}, {20, 4}, true}}, false})};
        QVERIFY(app::moveHandle(path[0], 1, Side::Out, {18, 7}));
        QVERIFY(glm::distance(path[0].nodes[1].out, app::Point(18, 0)) < 1e-12);
        path[0].nodes[0].selected = true; // the far end of the line turns it
        app::moveSelected(path, {10, -10});
        QVERIFY(glm::distance(path[0].nodes[1].out, app::Point(10, 8)) < 1e-12);
    }
    void bendingMovesThatPointByThatVector()
    {
        app::NodeSubpath path = nodesOf(wave());
        for (auto& node : path.nodes)
            node.type = app::NodeType::Corner;
        const app::Bezier before = path.segment(0);
        for (const double t : {0.1, 0.5, 0.8}) {
            app::NodeSubpath bent = path;
            QVERIFY(app::bendSegment(bent, 0, t, {3, 5}));
            QVERIFY(glm::distance(bent.segment(0).at(t), before.at(t) + app::Point(3, 5)) < 1e-9);
            QCOMPARE(bent.segment(1).control2, path.segment(1).control2);
        }
    }
    void goesFromNodeToNodeInTheOrderOfThePath()
    {
        const app::NodePath path{polyline({{0, 0}, {1, 0}}), {}, polyline({{3, 3}})};
        std::optional<app::NodeAddress> at;
        std::vector<app::NodeAddress> visited;
        for (int i = 0; i < 4; ++i)
            visited.push_back(*(at = app::neighbour(path, at, true)));
        QVERIFY((visited == std::vector<app::NodeAddress>{{0, 0}, {0, 1}, {2, 0}, {0, 0}}));
        QVERIFY((*app::neighbour(path, at, false) == app::NodeAddress{2, 0}));
        QVERIFY(!app::neighbour({}, {}, true));
    }
};

} // namespace nodes_node_moves_test

TEST_CLASS(nodes_node_moves_test::NodeMovesTest, None)
#include "tests/app/nodes/node_moves_test.moc"

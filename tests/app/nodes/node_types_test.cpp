// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_types.h"

#include <QTest>

#include "tests/app/nodes/shapes.h"
#include "tests/test_class.h"

namespace nodes_node_types_test {

class NodeTypesTest : public QObject {
    Q_OBJECT

    static double angleBetweenHandles(const app::Node& node)
    {
        const app::Point in = node.at - node.in, out = node.out - node.at;
        return std::abs(std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out)));
    }

private slots:
    void smoothCornersOfAPolylineGetHandlesAlongTheirNeighbours()
    {
        app::NodePath path{polyline({{0, 0}, {30, 0}, {30, 60}})};
        path[0].nodes[1].selected = true;
        QVERIFY(app::setTypes(path, app::NodeType::Smooth));
        const app::Node& node = path[0].nodes[1];
        QVERIFY(node.type == app::NodeType::Smooth && node.curved && path[0].nodes[0].curved);
        QVERIFY(angleBetweenHandles(node) < 1e-12);
        QVERIFY(std::abs(glm::distance(node.in, node.at) - 10) < 1e-12);
        QVERIFY(std::abs(glm::distance(node.out, node.at) - 20) < 1e-12);
        QCOMPARE(path[0].nodes[0].out, app::Point(10, 0)); // as straight as before
    }
    void allCornersOfAPolylineBecomeSmoothAlike()
    {
        app::NodePath path{polyline({{0, 0}, {30, 30}, {60, 0}, {90, 30}})};
        app::selectAll(path, true);
        QVERIFY(app::setTypes(path, app::NodeType::Smooth));
        for (const std::size_t i : {0, 1, 2})
            QVERIFY(path[0].nodes[i].curved);
        for (const std::size_t i : {1, 2}) { // tops and bottoms
            QVERIFY(std::abs(path[0].nodes[i].in.y - path[0].nodes[i].at.y) < 1e-12);
            QVERIFY(std::abs(path[0].nodes[i].out.y - path[0].nodes[i].at.y) < 1e-12);
        }
    }
    void smoothKeepsTheLengthsOfHandlesAndSymmetricTheirMean()
    {
        app::NodePath path{
            nodesOf({{0, 0},
                     {{{60, 0}, {20, -40}, {60, -10}, true}, {{120, 10}, {80, 0}, {100, 60}, true}},
                     false})};
        app::Node& node = path[0].nodes[1];
        QCOMPARE(node.type, app::NodeType::Corner);
        node.selected = true;
        app::setTypes(path, app::NodeType::Smooth);
        QVERIFY(angleBetweenHandles(node) < 1e-12);
        QVERIFY(std::abs(glm::distance(node.in, node.at) - 10) < 1e-12);
        QVERIFY(std::abs(glm::distance(node.out, node.at) - 20) < 1e-12);
        app::setTypes(path, app::NodeType::Symmetric);
        QCOMPARE(node.type, app::NodeType::Symmetric);
        QVERIFY(std::abs(glm::distance(node.out, node.at) - 15) < 1e-12);
        QVERIFY(glm::distance(node.in + node.out, node.at * 2.0) < 1e-12);
        const app::NodePath before = path;
        app::setTypes(path, app::NodeType::Corner);
        QCOMPARE(node.type, app::NodeType::Corner);
        QCOMPARE(node.in, before[0].nodes[1].in); // a corner changes no shape
    }
    void besideALineTheHandleIsPutInLine()
    {
        app::NodePath path{
            nodesOf({{0, 0}, {{{10, 0}}, {{20, 9}, {10, 5}, {20, 4}, true}}, false})};
        path[0].nodes[1].selected = true;
        app::setTypes(path, app::NodeType::Smooth);
        QVERIFY(glm::distance(path[0].nodes[1].out, app::Point(15, 0)) < 1e-12);
        QVERIFY(!path[0].nodes[0].curved);
        app::setTypes(path, app::NodeType::Symmetric); // needs two handles
        QVERIFY(path[0].nodes[0].curved);
        QCOMPARE(app::typeOf(path[0], 1), app::NodeType::Symmetric);
    }
    void handlesWithoutLengthGetOne()
    {
        app::NodePath path{
            nodesOf({{0, 0},
                     {{{30, 0}, {0, 0}, {30, 0}, true}, {{60, 30}, {30, 0}, {60, 30}, true}},
                     false})};
        path[0].nodes[1].selected = true;
        QVERIFY(app::setTypes(path, app::NodeType::Smooth));
        QCOMPARE(app::typeOf(path[0], 1), app::NodeType::Smooth);
    }
    void nodesOnOneSpotStayFinite()
    {
        for (const auto type : {app::NodeType::Smooth, app::NodeType::Symmetric}) {
            app::NodePath path{polyline({{5, 5}, {5, 5}, {5, 5}, {5, 5}}, true)};
            app::selectAll(path, true);
            QVERIFY(app::setTypes(path, type));
            QVERIFY(app::isFinite(path));
            QCOMPARE(path[0].nodes[0].at, app::Point(5, 5));
        }
    }
    void endsOfOpenPathsStayCorners()
    {
        app::NodePath path{nodesOf(wave())};
        path[0].nodes[0].selected = path[0].nodes[2].selected = true;
        QVERIFY(!app::setTypes(path, app::NodeType::Smooth));
        QCOMPARE(path[0].nodes[0].type, app::NodeType::Corner);
    }
};

} // namespace nodes_node_types_test

TEST_CLASS(nodes_node_types_test::NodeTypesTest, None)
#include "tests/app/nodes/node_types_test.moc"

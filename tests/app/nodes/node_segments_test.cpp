// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_segments.h"

#include <QTest>

#include "tests/app/nodes/shapes.h"
#include "tests/test_class.h"

namespace nodes_node_segments_test {

class NodeSegmentsTest : public QObject {
    Q_OBJECT

private slots:
    void anInsertedNodeChangesNoShape()
    {
        for (const auto& original : {nodesOf(wave()), nodesOf(circle(30))})
            for (std::size_t segment = 0; segment < original.segmentCount(); ++segment)
                for (const double t : {0.001, 0.3, 0.5, 0.999}) {
                    app::NodeSubpath path = original;
                    const auto added = app::insertNode(path, segment, t);
                    QCOMPARE(added.value(), segment + 1);
                    const app::Bezier whole = original.segment(segment);
                    QVERIFY(glm::distance(path.nodes[*added].at, whole.at(t)) < 1e-12);
                    for (const double u : {0.1, 0.6, 1.0}) {
                        QVERIFY(glm::distance(path.segment(segment).at(u), whole.at(u * t))
                                < 1e-12);
                        QVERIFY(glm::distance(path.segment(segment + 1).at(u),
                                              whole.at(t + u * (1 - t)))
                                < 1e-12);
                    }
                    QVERIFY(path.nodes[*added].type != app::NodeType::Corner);
                }
    }
    void aStraightSegmentStaysStraight()
    {
        app::NodeSubpath square = polyline({{0, 0}, {8, 0}, {8, 4}}, true);
        QCOMPARE(app::insertNode(square, 2, 0.25).value(), std::size_t(3)); // the closing line
        QCOMPARE(square.nodes[3].at, app::Point(6, 3));
        QVERIFY(!square.nodes[2].curved && !square.nodes[3].curved);
        QCOMPARE(square.nodes[3].type, app::NodeType::Corner);
    }
    void aLoopOfOneNodeIsDividedToo()
    {
        const app::NodeSubpath loop =
            nodesOf({{0, 0}, {{{0, 0}, {30, 30}, {-30, 30}, true}}, true});
        app::NodeSubpath path = loop;
        QVERIFY(app::insertNode(path, 0, 0.5));
        QCOMPARE(path.nodes.size(), std::size_t(2));
        QVERIFY(apart(loop, path) < 1e-3);
    }
    void refusesParametersOutside()
    {
        app::NodeSubpath path = nodesOf(wave());
        for (const double t : {-1.0, 0.0, 1.0, 2.0, double(NAN)})
            QVERIFY(!app::insertNode(path, 0, t));
        QVERIFY(!app::insertNode(path, 2, 0.5));
        QCOMPARE(path.nodes.size(), std::size_t(3));
    }
    void changesTheSegmentsBetweenSelectedNodes()
    {
        app::NodePath path{polyline({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, true)};
        path[0].nodes[1].selected = path[0].nodes[2].selected = true;
        QVERIFY(app::makeCurved(path));
        QVERIFY(path[0].nodes[1].curved && !path[0].nodes[0].curved && !path[0].nodes[2].curved);
        QVERIFY(glm::distance(path[0].nodes[1].out, app::Point(9, 3)) < 1e-12);
        QVERIFY(glm::distance(path[0].nodes[2].in, app::Point(9, 6)) < 1e-12);
        QVERIFY(!app::makeCurved(path)); // it is one already
        QVERIFY(app::makeStraight(path));
        QCOMPARE(path[0].nodes[1].out, app::Point(9, 0));
    }
    void orThoseBesideASingleNode()
    {
        app::NodePath path{nodesOf(circle(9))};
        path[0].nodes[0].selected = true;
        QVERIFY(app::makeStraight(path));
        QVERIFY(!path[0].nodes[0].curved && !path[0].nodes[3].curved && path[0].nodes[1].curved);
        QCOMPARE(path[0].nodes[0].type, app::NodeType::Corner);
        app::selectAll(path, false);
        QVERIFY(!app::makeStraight(path));
    }
};

} // namespace nodes_node_segments_test

TEST_CLASS(nodes_node_segments_test::NodeSegmentsTest, None)
#include "tests/app/nodes/node_segments_test.moc"

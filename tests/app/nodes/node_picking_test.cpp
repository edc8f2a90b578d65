// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_picking.h"

#include <QTest>

#include "tests/app/nodes/shapes.h"
#include "tests/test_class.h"

namespace nodes_node_picking_test {

class NodePickingTest : public QObject {
    Q_OBJECT

private slots:
    void findsTheNearestNode()
    {
        const app::NodePath path{polyline({{0, 0}, {10, 0}}), polyline({{10, 3}})};
        QVERIFY((app::nodeAt(path, {9, 0.5}, 2) == app::NodeAddress{0, 1}));
        QVERIFY((app::nodeAt(path, {10, 2}, 5) == app::NodeAddress{1, 0}));
        QVERIFY(!app::nodeAt(path, {5, 0}, 2));
        QVERIFY(!app::nodeAt(path, {NAN, 0}, 2));
    }
    void ofNodesOnOneSpotASelectedOneElseTheLast()
    {
        app::NodePath path{polyline({{5, 5}, {5, 5}, {5, 5}})};
        QVERIFY((app::nodeAt(path, {5, 6}, 2) == app::NodeAddress{0, 2}));
        path[0].nodes[1].selected = true;
        QVERIFY((app::nodeAt(path, {5, 6}, 2) == app::NodeAddress{0, 1}));
    }
    void countsTheNodesOnOneSpot()
    {
        const app::NodePath path{polyline({{5, 5}, {9, 5}, {5, 5}}), polyline({{5, 5}, {5, 6}})};
        QCOMPARE(app::nodesOn(path, {5, 5}), std::size_t(3));
        QCOMPARE(app::nodesOn(path, {9, 5}), std::size_t(1));
        QCOMPARE(app::nodesOn(path, {5, 5.5}), std::size_t(0));
    }
    void selectsWhatTheRectangleHolds()
    {
        app::NodePath path{polyline({{0, 0}, {5, 5}, {10, 0}})};
        app::selectWithin(path, {{0, 0}, {5, 5}});
        QVERIFY(path[0].nodes[0].selected && path[0].nodes[1].selected
                && !path[0].nodes[2].selected);
    }
    void showsTheHandlesOfSelectedNodesAndTheirNeighbours()
    {
        app::NodePath path{nodesOf(circle(10))};
        QVERIFY(app::shownHandles(path).empty());
        path[0].nodes[1].selected = true;
        const auto one = app::shownHandles(path);
        QCOMPARE(one.size(), std::size_t(4));
        QCOMPARE(std::ranges::count_if(one, &app::ShownHandle::neighbours), std::ptrdiff_t(2));
        QCOMPARE(one[0].at, path[0].nodes[1].in);
        QCOMPARE(one[2].at, path[0].nodes[0].out);
        path[0].nodes[2].selected = true; // each handle once
        QCOMPARE(app::shownHandles(path).size(), std::size_t(6));
    }
    void manySelectedNodesShowNoHandles()
    {
        app::NodePath path(101, nodesOf(circle(10)));
        for (auto& subpath : path)
            subpath.nodes[0].selected = true;
        QVERIFY(app::shownHandles(path).empty());
        path.pop_back();
        QVERIFY(!app::shownHandles(path).empty());
    }
    void findsThePointOfTheNearestSegment()
    {
        const app::NodePath path{nodesOf(wave()), polyline({{0, 50}, {10, 50}, {10, 60}}, true)};
        for (const double t : {0.05, 0.4, 0.77}) {
            const app::Point at = path[0].segment(1).at(t);
            const auto found = app::segmentAt(path, at + app::Point(0, 1e-3), 1);
            QVERIFY(found && found->segment == (app::NodeAddress{0, 1}));
            QVERIFY(std::abs(found->t - t) < 1e-3);
        }
        const auto closing = app::segmentAt(path, {5, 56}, 2);
        QVERIFY(closing && closing->segment == (app::NodeAddress{1, 2}));
        QVERIFY(glm::distance(closing->at, app::Point(5.5, 55.5)) < 1e-12);
        QVERIFY(!app::segmentAt(path, {60, -60}, 5));
        const app::NodePath spot{polyline({{3, 3}, {3, 3}})};
        QVERIFY(app::segmentAt(spot, {3, 4}, 2));
    }
};

} // namespace nodes_node_picking_test

TEST_CLASS(nodes_node_picking_test::NodePickingTest, None)
#include "tests/app/nodes/node_picking_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/subpath_edits.h"

#include <QTest>

#include "tests/app/nodes/shapes.h"
#include "tests/test_class.h"

namespace nodes_subpath_edits_test {

class SubpathEditsTest : public QObject {
    Q_OBJECT

    static app::NodePath split(app::NodeSubpath subpath, std::vector<std::size_t> nodes)
    {
        for (const std::size_t node : nodes)
            subpath.nodes[node].selected = true;
        app::NodePath path{subpath};
        app::splitAtSelected(path);
        return path;
    }

private slots:
    void reversedItRunsTheOtherWayThroughTheSamePoints()
    {
        for (const auto& original :
             {nodesOf(wave()), nodesOf(circle(7)), polyline({{0, 0}, {5, 0}, {9, 9}}, true),
              nodesOf({{0, 0}, {{{10, 0}}, {{20, 9}, {15, 0}, {20, 4}, true}}, true})}) {
            app::NodeSubpath path = original;
            app::reverse(path);
            const std::size_t last = original.segmentCount() - 1;
            for (std::size_t i = 0; i <= last; ++i)
                for (const double t : {0.0, 0.2, 0.5})
                    QVERIFY(
                        glm::distance(path.segment(i).at(t), original.segment(last - i).at(1 - t))
                        < 1e-12);
            if (original.closed)
                QCOMPARE(path.nodes[0].at, original.nodes[0].at);
            app::reverse(path);
            QCOMPARE(path, original);
        }
    }
    void closesByALineOrInOneSpot()
    {
        app::NodeSubpath path = polyline({{0, 0}, {5, 0}, {5, 5}});
        QVERIFY(app::close(path));
        QCOMPARE(path, polyline({{0, 0}, {5, 0}, {5, 5}}, true));
        QVERIFY(!app::close(path));
        app::NodeSubpath spot = polyline({{0, 0}, {5, 0}, {5, 5}, {0, 0}});
        QVERIFY(app::close(spot));
        QCOMPARE(spot, path);
        app::NodeSubpath point = polyline({{0, 0}});
        QVERIFY(!app::close(point));
    }
    void opensWithoutLosingASegment()
    {
        for (std::size_t at = 0; at < 4; ++at) {
            app::NodeSubpath path = nodesOf(circle(20));
            QVERIFY(app::open(path, at));
            QVERIFY(!path.closed && path.nodes.size() == 5 && path.segmentCount() == 4);
            QCOMPARE(path.nodes.front().at, nodesOf(circle(20)).nodes[at].at);
            QCOMPARE(path.nodes.back().at, path.nodes.front().at);
            QVERIFY(apart(nodesOf(circle(20)), path) < 1e-9);
            QVERIFY(app::close(path)); // and closes to the same shape again
            QVERIFY(apart(nodesOf(circle(20)), path) < 1e-9);
        }
        app::NodeSubpath open = nodesOf(wave());
        QVERIFY(!app::open(open, 1));
    }
    void splittingAClosedPathOpensItAndAnOpenOneGivesTwo()
    {
        const app::NodePath one = split(nodesOf(circle(20)), {2});
        QVERIFY(one.size() == 1 && !one[0].closed);
        QVERIFY(one[0].nodes.front().at == app::Point(-20, 0));
        QVERIFY(one[0].nodes.front().selected && !one[0].nodes.back().selected);

        const app::NodePath halves = split(nodesOf(circle(20)), {0, 2});
        QCOMPARE(halves.size(), std::size_t(2));
        QVERIFY(halves[0].nodes.size() == 3 && halves[1].nodes.size() == 3);
        QCOMPARE(halves[0].nodes.back().at, halves[1].nodes.front().at);
        for (const auto& half : halves)
            QVERIFY(apart(half, nodesOf(circle(20))) < 1e-9);

        const app::NodePath two = split(nodesOf(wave()), {1});
        QCOMPARE(two.size(), std::size_t(2));
        QVERIFY(two[0].segment(0).control2 == nodesOf(wave()).segment(0).control2);
        QVERIFY(two[1].segment(0).control1 == nodesOf(wave()).segment(1).control1);
    }
    void atAnEndThereIsNothingToSplit()
    {
        app::NodePath path{nodesOf(wave())};
        path[0].nodes[0].selected = path[0].nodes[2].selected = true;
        const app::NodePath before = path;
        QVERIFY(!app::splitAtSelected(path));
        QCOMPARE(path, before);
    }
};

} // namespace nodes_subpath_edits_test

TEST_CLASS(nodes_subpath_edits_test::SubpathEditsTest, None)
#include "tests/app/nodes/subpath_edits_test.moc"

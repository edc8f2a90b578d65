// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/end_joining.h"
#include "app/nodes/subpath_edits.h"

#include <QTest>

#include <numeric>

#include "tests/app/nodes/shapes.h"

class EndJoiningTest : public QObject {
    Q_OBJECT

    static std::size_t join(app::NodePath& path, double tolerance)
    {
        std::vector<std::size_t> owners(path.size());
        std::iota(owners.begin(), owners.end(), std::size_t(0));
        const std::size_t joints = app::joinEnds(path, owners, tolerance);
        if (owners.size() != path.size() || !std::ranges::is_sorted(owners))
            return 99;
        return joints;
    }

private slots:
    void fourLooseLinesBecomeOneClosedPath()
    {
        app::NodePath path{polyline({{0, 0}, {10, 0}}), polyline({{10, 10}, {10, 0}}),
                           polyline({{0, 10}, {10, 10}}), polyline({{0, 10}, {0, 0}})};
        QCOMPARE(join(path, 0.5), std::size_t(4));
        QCOMPARE(path.size(), std::size_t(1));
        QVERIFY(path[0].closed && path[0].nodes.size() == 4);
        double around = 0;
        for (std::size_t i = 0; i < 4; ++i)
            around += glm::distance(path[0].segment(i).from, path[0].segment(i).to);
        QCOMPARE(around, 40.0);
    }
    void everyOrderAndDirectionOfTheLinesWorks()
    {
        std::vector<int> order{0, 1, 2, 3};
        const std::array<app::Point, 4> corners{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
        do
            for (int turned = 0; turned < 16; ++turned) {
                app::NodePath path;
                for (const int i : order) {
                    path.push_back(
                        polyline({corners[std::size_t(i)], corners[std::size_t(i + 1) % 4]}));
                    if (turned >> i & 1)
                        app::reverse(path.back());
                }
                QCOMPARE(join(path, 0.1), std::size_t(4));
                QVERIFY(path.size() == 1 && path[0].closed && path[0].nodes.size() == 4);
                for (std::size_t i = 0; i < 4; ++i)
                    QCOMPARE(glm::distance(path[0].segment(i).from, path[0].segment(i).to), 10.0);
            }
        while (std::ranges::next_permutation(order).found);
    }
    void endsMeetInTheMiddleWithTheirHandles()
    {
        app::NodePath path{nodesOf({{0, 0}, {{{10, 0}, {2, 5}, {8, 1}, true}}, false}),
                           nodesOf({{11, 1}, {{{20, 0}, {13, 0}, {18, 5}, true}}, false})};
        QCOMPARE(join(path, 2), std::size_t(1));
        QCOMPARE(path[0].nodes[1].at, app::Point(10.5, 0.5));
        QCOMPARE(path[0].nodes[1].in, app::Point(8.5, 1.5));
        QCOMPARE(path[0].nodes[1].out, app::Point(12.5, -0.5));
        QVERIFY(path[0].nodes[0].curved && path[0].nodes[1].curved && !path[0].nodes[2].curved);
    }
    void theNearestEndsAreJoinedFirst()
    {
        app::NodePath path{polyline({{0, 0}, {10, 0}}), polyline({{10.4, 0}, {20, 0}}),
                           polyline({{10, 0.1}, {10, 20}})};
        QCOMPARE(join(path, 0.5), std::size_t(1));
        QCOMPARE(path.size(), std::size_t(2));
        QCOMPARE(path[0].nodes.back().at, app::Point(10, 20));
    }
    void twoSelectedEndsAreJoinedByALineIfTheyAreFarApart()
    {
        app::NodePath path{polyline({{0, 0}, {10, 0}}), polyline({{30, 0}, {20, 0}})};
        QCOMPARE(join(path, 1), std::size_t(0)); // nothing is selected
        path[0].nodes[1].selected = path[1].nodes[1].selected = true;
        QCOMPARE(join(path, 1), std::size_t(1));
        QCOMPARE(app::subpathsOf(path),
                 app::subpathsOf(std::array{polyline({{0, 0}, {10, 0}, {20, 0}, {30, 0}})}));
        app::NodePath open{polyline({{0, 0}, {10, 0}, {10, 9}})};
        open[0].nodes[0].selected = open[0].nodes[2].selected = true;
        QCOMPARE(join(open, 1), std::size_t(1));
        QVERIFY(open[0].closed && open[0].nodes.size() == 3);
    }
    void onlySelectedEndsCount()
    {
        app::NodePath path{polyline({{0, 0}, {10, 0}}), polyline({{10, 0}, {10, 9}}),
                           polyline({{10, 9}, {0, 0}})};
        path[0].nodes[1].selected = path[1].nodes[0].selected = true;
        QCOMPARE(join(path, 1), std::size_t(1));
        QCOMPARE(path.size(), std::size_t(2));
    }
    void aShortLineIsNotJoinedToItself()
    {
        app::NodePath path{polyline({{0, 0}, {0.2, 0}})};
        QCOMPARE(join(path, 1), std::size_t(0));
        QVERIFY(!path[0].closed);
    }
    void closedPathsAndPointsHaveNoEnds()
    {
        app::NodePath path{nodesOf(circle(5)), polyline({{5, 0}}), polyline({{5, 0}, {9, 0}})};
        const app::NodePath before = path;
        QCOMPARE(join(path, 1), std::size_t(0));
        QCOMPARE(path, before);
    }
    void whatWasSplitIsSmoothAgainWhenItIsJoined()
    {
        app::NodePath path{nodesOf(circle(20))};
        path[0].nodes[0].selected = path[0].nodes[2].selected = true;
        app::splitAtSelected(path);
        app::selectAll(path, false);
        QCOMPARE(join(path, 0.01), std::size_t(2));
        QVERIFY(path.size() == 1 && path[0].closed && path[0].nodes.size() == 4);
        for (const app::Node& node : path[0].nodes)
            QCOMPARE(node.type, app::NodeType::Symmetric);
        QVERIFY(apart(path[0], nodesOf(circle(20))) < 1e-9);
    }
    void manyEndsOnOneSpotComeToAnEnd()
    {
        app::NodePath path;
        for (int i = 0; i < 20'000; ++i)
            path.push_back(polyline({{0, 0}, {double(i), 5}}));
        QVERIFY(join(path, 0.1) > 0);
        QVERIFY(app::isFinite(path));
    }
};

QTEST_APPLESS_MAIN(EndJoiningTest)
#include "end_joining_test.moc"

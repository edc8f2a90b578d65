// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/end_joining.h"
#include "app/nodes/subpath_edits.h"

#include <QTest>

#include <numeric>
#include <random>
#include <set>

#include "tests/app/nodes/shapes.h"
#include "tests/test_class.h"

namespace nodes_end_joining_test {

class EndJoiningTest : public QObject {
    Q_OBJECT

    /// End 2 i is the start of subpath i, end 2 i + 1 its last node.
    struct Pair {
        double distance;
        std::size_t a, b;
        auto operator<=>(const Pair&) const = default;
    };
    static app::Point placeOf(const app::NodePath& path, std::size_t end)
    {
        const auto& nodes = path[end / 2].nodes;
        return (end % 2 ? nodes.back() : nodes.front()).at;
    }
    static std::vector<Pair> nearestPairs(const app::NodePath& path,
                                          const std::vector<std::uint32_t>& pens, double tolerance)
    {
        std::vector<Pair> pairs, chosen;
        for (std::size_t a = 0; a < 2 * path.size(); ++a)
            for (std::size_t b = a + 1; b < 2 * path.size(); ++b) {
                const bool oneLine = a / 2 == b / 2 && path[a / 2].nodes.size() == 2;
                const app::Point by = placeOf(path, b) - placeOf(path, a);
                const double apart = std::hypot(by.x, by.y);
                if (!oneLine && apart <= tolerance && pens[a / 2] == pens[b / 2])
                    pairs.push_back({apart, a, b});
            }
        std::ranges::sort(pairs);
        std::set<std::size_t> used;
        for (const Pair& pair : pairs)
            if (!used.contains(pair.a) && !used.contains(pair.b)) {
                used.insert({pair.a, pair.b});
                chosen.push_back(pair);
            }
        return chosen;
    }
    static std::size_t join(app::NodePath& path, double tolerance,
                            std::vector<std::uint32_t> pens = {})
    {
        std::vector<std::size_t> owners(path.size());
        std::iota(owners.begin(), owners.end(), std::size_t(0));
        pens.resize(path.size());
        const std::size_t joints = app::joinEnds(path, owners, tolerance, pens);
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
    void onlyEndsOfOnePenAreJoined()
    {
        app::NodePath path{polyline({{0, 0}, {10, 0}}), polyline({{10, 0}, {20, 0}}),
                           polyline({{20, 0}, {30, 0}}), polyline({{10, 0.1}, {10, 9}})};
        QCOMPARE(join(path, 1, {1, 2, 1, 1}), std::size_t(1)); // the first and the last
        QCOMPARE(path.size(), std::size_t(3));
        QCOMPARE(path[0].nodes.back().at, app::Point(10, 9));
        path = {polyline({{0, 0}, {10, 0}}), polyline({{20, 0}, {30, 0}})};
        path[0].nodes[1].selected = path[1].nodes[0].selected = true;
        QCOMPARE(join(path, 1, {1, 2}), std::size_t(0)); // not by a line either
        QCOMPARE(join(path, 100, {1, 2}), std::size_t(0));
        QCOMPARE(join(path, 1, {2, 2}), std::size_t(1));
    }
    void aClosedPathBeginsWhereItsEarliestOneDid()
    {
        app::NodePath path{polyline({{10, 10}, {10, 0}}), polyline({{0, 0}, {10, 0}}),
                           polyline({{10, 10}, {0, 10}, {0, 0}})};
        QCOMPARE(join(path, 0.1), std::size_t(3));
        QVERIFY(path[0].closed);
        QCOMPARE(app::subpathsOf(path),
                 app::subpathsOf(std::array{polyline({{10, 10}, {10, 0}, {0, 0}, {0, 10}}, true)}));
    }
    // Whatever the shapes, the pairs are those that one finds by looking at all of them.
    void pairsAreTheNearestOfAll()
    {
        std::mt19937 random(3);
        for (int round = 0; round < 2000; ++round) {
            std::uniform_int_distribution<int> place(0, round % 2 ? 9 : 60); // often on one spot
            app::NodePath path;
            std::vector<std::uint32_t> pens;
            for (int i = 0; i < 2 + round % 14; ++i) {
                std::vector<app::Point> corners;
                for (auto n = 2 + random() % 2; n > 0; --n)
                    corners.emplace_back(0.5 * place(random), 0.5 * place(random));
                path.push_back(polyline(corners));
                pens.push_back(random() % 3 == 0);
            }
            const double tolerance = 0.5 * (random() % 8);
            const app::NodePath before = path;
            const auto expected = nearestPairs(before, pens, tolerance);
            const std::size_t joints = join(path, tolerance, pens);
            QCOMPARE(joints, expected.size());
            std::vector<app::Point> ends; // that are left
            for (std::size_t end = 0; end < 2 * before.size(); ++end)
                if (std::ranges::none_of(expected,
                                         [&](const Pair& p) { return p.a == end || p.b == end; }))
                    ends.push_back(placeOf(before, end));
            std::vector<app::Point> found;
            for (const app::NodeSubpath& subpath : path)
                if (!subpath.closed) {
                    found.push_back(subpath.nodes.front().at);
                    found.push_back(subpath.nodes.back().at);
                }
            const auto byPlace = [](const app::Point& p) { return std::pair(p.x, p.y); };
            std::ranges::sort(ends, {}, byPlace);
            std::ranges::sort(found, {}, byPlace);
            QCOMPARE(found, ends);
            QCOMPARE(app::nodeCount(path), app::nodeCount(before) - joints);
        }
    }
    void manyEndsOnOneSpotComeToAnEnd()
    {
        app::NodePath path;
        for (int i = 0; i < 200'000; ++i)
            path.push_back(polyline({{0, 0}, {double(i), 5}}));
        QCOMPARE(join(path, 0.1), std::size_t(100'000));
        QVERIFY(app::isFinite(path));
    }
    // In each of these, looking at every pair, or moving a long chain for each joint, takes
    // minutes.
    void manyLinesComeToAnEnd()
    {
        constexpr int count = 50'000;
        app::NodePath backwards, column, crowd;
        std::mt19937 random(5);
        std::uniform_real_distribution<double> place(0, 1);
        for (int i = 0; i < count; ++i) {
            backwards.push_back(polyline({{double(count - i), 0}, {double(count - i - 1), 0.1}}));
            column.push_back(polyline({{0, double(i)}, {9, double(i)}}));
            crowd.push_back(polyline({{place(random), place(random)}, {place(random), 1}}));
        }
        for (app::NodeSubpath& line : backwards)
            if (random() % 2)
                app::reverse(line);
        QCOMPARE(join(backwards, 0.5), std::size_t(count - 1));
        QCOMPARE(backwards.size(), std::size_t(1));
        QCOMPARE(join(column, 0.9), std::size_t(0));
        QVERIFY(join(crowd, 2) > std::size_t(count) - 100);
    }
};

} // namespace nodes_end_joining_test

TEST_CLASS(nodes_end_joining_test::EndJoiningTest, None)
#include "tests/app/nodes/end_joining_test.moc"

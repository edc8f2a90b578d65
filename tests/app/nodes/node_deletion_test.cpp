// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/curve_fit.h"
#include "app/nodes/node_deletion.h"
#include "app/nodes/node_segments.h"

#include <QTest>

#include "tests/app/nodes/shapes.h"
#include "tests/test_class.h"

namespace nodes_node_deletion_test {

class NodeDeletionTest : public QObject {
    Q_OBJECT

    static app::NodeSubpath without(app::NodeSubpath subpath, std::vector<std::size_t> nodes)
    {
        for (const std::size_t node : nodes)
            subpath.nodes[node].selected = true;
        app::NodePath path{subpath};
        app::deleteSelected(path);
        return path.empty() ? app::NodeSubpath{} : path[0];
    }

private slots:
    void nodesThatWereAddedLeaveTheCurveAsItWas()
    {
        const app::NodeSubpath one =
            nodesOf({{0, 0}, {{{90, 20}, {10, 80}, {70, -60}, true}}, false});
        for (const double t : {0.05, 0.3, 0.5, 0.9}) {
            app::NodeSubpath path = one;
            app::insertNode(path, 0, t);
            app::insertNode(path, 1, 0.4);
            app::insertNode(path, 0, 0.7);
            const app::NodeSubpath back = without(path, {1, 2, 3});
            QCOMPARE(back.nodes.size(), std::size_t(2));
            QVERIFY(glm::distance(back.nodes[0].out, one.nodes[0].out) < 1e-9);
            QVERIFY(glm::distance(back.nodes[1].in, one.nodes[1].in) < 1e-9);
        }
    }
    void aCircleWithoutANodeIsStillNearlyRound()
    {
        const app::NodeSubpath round = nodesOf(circle(100));
        for (std::size_t node = 0; node < 4; ++node) {
            const app::NodeSubpath left = without(round, {node});
            QCOMPARE(left.nodes.size(), std::size_t(3));
            QVERIFY(left.closed);
            QVERIFY2(apart(left, round) < 2, qPrintable(QString::number(apart(left, round))));
        }
    }
    // The best curve for half a circle with vertical ends has handles of 4/3 r at first order.
    void noOtherHandlesAreBetter()
    {
        const auto pieces =
            std::array{nodesOf(circle(100)).segment(0), nodesOf(circle(100)).segment(1)};
        const app::Bezier best = app::fitted(pieces);
        QVERIFY(std::abs(best.control1.x - 100) < 1e-9 && std::abs(best.control2.x + 100) < 1e-9);
        const auto error = [](const app::Bezier& curve) {
            double sum = 0;
            for (int i = 1; i < 200; ++i)
                sum += std::pow(glm::length(curve.at(i / 200.0)) - 100, 2);
            return sum;
        };
        for (const double factor : {0.98, 1.02}) {
            app::Bezier other = best;
            other.control1.y *= factor;
            other.control2.y *= factor;
            QVERIFY(error(best) < error(other));
        }
    }
    void linesStayLinesAndWhatIsBesideStaysUntouched()
    {
        const app::NodeSubpath corners = polyline({{0, 0}, {3, 9}, {9, 4}, {12, 0}, {20, 0}});
        const app::NodeSubpath left = without(corners, {1, 2});
        QCOMPARE(left, polyline({{0, 0}, {12, 0}, {20, 0}}));
        QCOMPARE(without(corners, {0, 4}), polyline({{3, 9}, {9, 4}, {12, 0}}));
        const app::NodeSubpath square = polyline({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, true);
        QCOMPARE(without(square, {0}), polyline({{9, 0}, {9, 9}, {0, 9}}, true));
    }
    void aLineAndACurveBecomeACurveThatLeavesAlongTheLine()
    {
        const app::NodeSubpath path =
            nodesOf({{0, 0}, {{{10, 0}}, {{20, 9}, {15, 0}, {20, 4}, true}}, false});
        const app::NodeSubpath left = without(path, {1});
        QVERIFY(left.nodes[0].curved);
        QVERIFY(left.nodes[0].out.x > 0 && std::abs(left.nodes[0].out.y) < 1e-12);
        QVERIFY(std::abs(left.nodes[1].in.x - 20) < 1e-9 && left.nodes[1].in.y < 9);
        QVERIFY(apart(left, path) < 0.5);
    }
    void whatHasNoSegmentLeftIsRemoved()
    {
        app::NodePath path{polyline({{0, 0}, {1, 1}}), nodesOf(circle(5)), polyline({{7, 7}})};
        path[0].nodes[0].selected = true;
        app::selectAll(std::span(path).subspan(1, 1), true);
        QVERIFY(app::deleteSelected(path));
        QCOMPARE(path.size(), std::size_t(1));
        QCOMPARE(path[0].nodes[0].at, app::Point(7, 7));
        QVERIFY(!app::deleteSelected(path));
    }
    void handlesWithoutLengthAndNodesOnOneSpotStayFinite()
    {
        app::NodeSubpath path = nodesOf({{0, 0},
                                         {{{0, 0}, {0, 0}, {0, 0}, true},
                                          {{5, 5}, {0, 0}, {5, 5}, true},
                                          {{5, 5}, {5, 5}, {5, 5}, true}},
                                         false});
        app::NodePath left{without(path, {1, 2})};
        QCOMPARE(left[0].nodes.size(), std::size_t(2));
        QVERIFY(app::isFinite(left));
        const app::Point spot(3, 3);
        const app::Bezier nothing = app::fitted(std::array{app::Bezier{spot, spot, spot, spot}});
        QVERIFY(nothing.control1 == spot && nothing.to == spot);
    }
    void hugeAndTinyShapesFitAlike()
    {
        const app::NodeSubpath unit = nodesOf(circle(1));
        const app::Bezier one = app::fitted(std::array{unit.segment(0), unit.segment(1)});
        for (const double size : {1e-9, 1e9, 1e150}) {
            const app::NodeSubpath scaled = nodesOf(circle(size));
            const app::Bezier fit = app::fitted(std::array{scaled.segment(0), scaled.segment(1)});
            QVERIFY(glm::distance(fit.control1 / size, one.control1) < 1e-9);
        }
    }
    /// Each with each, they would take hours.
    void aMillionNodesGoAtOnce()
    {
        app::NodeSubpath path;
        for (int i = 0; i < 1'000'000; ++i) {
            const app::Point at(i, std::sin(i * 1e-5) * 1e5);
            path.nodes.push_back({at, at - app::Point(0.3, 0), at + app::Point(0.3, 0),
                                  app::NodeType::Smooth, i + 1 < 1'000'000,
                                  i > 0 && i + 1 < 1'000'000});
        }
        app::NodePath all{std::move(path)};
        app::deleteSelected(all);
        QCOMPARE(all[0].nodes.size(), std::size_t(2));
        QVERIFY(app::isFinite(all));
    }
};

} // namespace nodes_node_deletion_test

TEST_CLASS(nodes_node_deletion_test::NodeDeletionTest, None)
#include "tests/app/nodes/node_deletion_test.moc"

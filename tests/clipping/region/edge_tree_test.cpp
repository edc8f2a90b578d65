// SPDX-License-Identifier: GPL-3.0-or-later
// The promises of clipping/region/edge_tree.h, against fractions; and that it lists few edges.
#include "clipping/region/edge_tree.h"

#include <QTest>

#include "tests/clipping/region/contract.h"
#include "tests/clipping/region/shapes.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace region_edge_tree_test {

using namespace clipping;

namespace {

using Point = region_oracle::Point<Rational>;

Point at(const glm::dvec2& p) { return {rational(p.x), rational(p.y)}; }

int side(const Point& from, const Point& to, const Point& p)
{
    const Rational left = region_oracle::cross<Rational>(to - from, p - from);
    return left > 0 ? 1 : left < 0 ? -1 : 0;
}

bool meet(const Segment& s, const Segment& t)
{
    const region_oracle::Edge<Rational> p{at(s.a), at(s.b)}, q{at(t.a), at(t.b)};
    if (p.has(q.from) || p.has(q.to) || q.has(p.from) || q.has(p.to))
        return true;
    return side(p.from, p.to, q.from) * side(p.from, p.to, q.to) < 0
           && side(q.from, q.to, p.from) * side(q.from, q.to, p.to) < 0;
}

/// How many edges a segment meets; fails if the tree does not list one of them.
int checkedMeetings(const Segment& s, std::span<const AreaEdge> edges, const EdgeTree& tree)
{
    std::vector<bool> isListed(edges.size(), false);
    tree.trace(s, [&](const auto& near) {
        for (const std::uint32_t edge : near)
            isListed[edge] = true;
    });
    int count = 0;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (meet(s, edges[i].segment)) {
            ++count;
            if (!isListed[i])
                QTest::qFail(exactly(s, Region{}).c_str(), __FILE__, __LINE__);
        }
    return count;
}

/// The winding numbers at a reference, which is moved to the left, and down by far less.
std::vector<int> windingsAt(const Reference& reference, std::span<const AreaEdge> edges,
                            std::size_t steps)
{
    const Rational little = rational(0x1p-90);
    const Point p = at(reference.at) - Point{little, little * little};
    std::vector<int> all(steps, 0);
    for (const auto& [segment, step, number] : edges) {
        const Point from = at(segment.a), to = at(segment.b);
        const bool isAbove = from.y > p.y;
        if (isAbove != (to.y > p.y) && side(from, to, p) == (isAbove ? -1 : 1))
            all[step] += isAbove ? -1 : 1;
    }
    return all;
}

/// Edges of an area whose points are on a grid, or nearly collinear, or of very different sizes.
Region someRegion(Random& random, int kind)
{
    Region region;
    HostilePoints hostile(random, true);
    for (int step = random.whole(1, 3); step > 0; --step) {
        Area area;
        for (int i = random.whole(3, 40); i > 0; --i)
            area.points.push_back(kind == 0   ? glm::dvec2(random.whole(0, 6), random.whole(0, 6))
                                  : kind == 1 ? hostile.next()
                                              : glm::dvec2(std::ldexp(random.unit(), -i), i % 2));
        region.steps.push_back({area});
    }
    return region;
}

// Combs with so many teeth, a star and a zigzag with so many points: their edges are alongside.
std::vector<glm::dvec2> comb(int teeth)
{
    std::vector<glm::dvec2> points;
    for (int i = 0; i < teeth; ++i)
        for (const int corner : {0, 1, 3, 2})
            points.push_back({(i + corner / 2 * 0.5) / teeth, corner % 2});
    points.insert(points.end(), {{1, 0}, {1, -1}, {0, -1}});
    return points;
}
std::vector<glm::dvec2> star(int rays)
{
    std::vector<glm::dvec2> points;
    for (int i = 0; i < 2 * rays; ++i)
        points.push_back((i % 2 ? 1.0 : 0.1)
                         * glm::dvec2(std::cos(M_PI * i / rays), std::sin(M_PI * i / rays)));
    return points;
}
/// All other edges are on one side of each.
std::vector<glm::dvec2> disc(int corners)
{
    std::vector<glm::dvec2> points;
    for (int i = 0; i < corners; ++i)
        points.push_back({std::cos(2 * M_PI * i / corners), std::sin(2 * M_PI * i / corners)});
    return points;
}

/// One side is divided into many edges.
std::vector<glm::dvec2> side(int edges)
{
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= edges; ++i)
        points.push_back({double(i) / edges, 0});
    points.push_back({0.5, 1});
    return points;
}

/// How many edges are listed along all edges together.
std::size_t listed(std::vector<glm::dvec2> points, double angle)
{
    for (glm::dvec2& p : points)
        p = {std::cos(angle) * p.x - std::sin(angle) * p.y,
             std::sin(angle) * p.x + std::cos(angle) * p.y};
    const auto edges = edgesOf({{{{std::move(points)}}}});
    const EdgeTree tree(edges, 1, boxOf(edges));
    std::size_t count = 0;
    for (const AreaEdge& edge : edges) {
        tree.trace(edge.segment, [&](const auto& near) { count += near.size(); });
        const auto anchor = tree.anchorNear(edge.segment.a);
        tree.trace({anchor.reference.at, edge.segment.a},
                   [&](const auto& near) { count += near.size(); });
    }
    return count;
}

} // namespace

class EdgeTreeTest : public QObject {
    Q_OBJECT

private slots:
    void everyMeetingIsListed()
    {
        Random random(1);
        int meetings = 0;
        for (int i = 0; i < 100 && !QTest::currentTestFailed(); ++i) {
            const Region region = someRegion(random, i % 3);
            const auto edges = edgesOf(region);
            if (edges.empty() || !EdgeTree::suits(boxOf(edges)))
                continue;
            const EdgeTree tree(edges, region.steps.size(), boxOf(edges), 1 + i % 4);
            for (int j = 0; j < 20; ++j) {
                const auto& other = edges[std::size_t(random.whole(0, int(edges.size()) - 1))];
                const double far = j % 5 == 0 ? 0x1p300 : 10;
                const glm::dvec2 any(random.between(-far, far), random.between(-far, far));
                const Segment s{other.segment.a, j % 2 ? any : other.segment.b};
                meetings += checkedMeetings(s, edges, tree);
            }
        }
        QVERIFY2(meetings > 10'000, QByteArray::number(meetings));
    }

    void segmentsOfAnySize()
    {
        Random random(2);
        const double most = Limits<double>::max();
        int meetings = 0;
        for (int i = 0; i < 20; ++i) {
            const auto edges = edgesOf(someRegion(random, 0));
            const EdgeTree tree(edges, 3, boxOf(edges), 1);
            for (const Segment& s : {Segment{{-most, -most}, {most, most}},
                                     Segment{{-most, 3}, {most, 3}}, Segment{{3, 3}, {3, 3}}})
                meetings += checkedMeetings(s, edges, tree);
        }
        QVERIFY(meetings > 100);
    }

    void anchorsKnowTheirWindings()
    {
        Random random(3);
        int others = 0;
        for (int i = 0; i < 60; ++i) {
            const Region region = someRegion(random, i % 2);
            const auto edges = edgesOf(region);
            const EdgeTree tree(edges, region.steps.size(), boxOf(edges), 1 + i % 4);
            for (int j = 0; j < 20; ++j) {
                const glm::dvec2 p(random.between(-8, 8), random.between(-8, 8));
                const auto [reference, windings] = tree.anchorNear(p);
                auto right = windingsAt(reference, edges, region.steps.size());
                for (const auto& [step, number] : windings) {
                    right[step] -= number;
                    ++others;
                }
                VERIFY_OR_SAY(std::ranges::count(right, 0) == std::ptrdiff_t(right.size()),
                              std::to_string(i).c_str());
            }
        }
        QVERIFY(others > 300);
    }

    void edgesAlongsideAreListedForFewOthers_data()
    {
        QTest::addColumn<double>("angle");
        for (const double angle : {0.0, 0.1, 0.7853981633974483, 1.5707963267948966})
            QTest::addRow("%g", angle) << angle;
    }
    void edgesAlongsideAreListedForFewOthers()
    {
        QFETCH(double, angle);
        for (const auto& [few, many] :
             {std::pair(comb(2'000), comb(4'000)), std::pair(star(4'000), star(8'000)),
              std::pair(disc(8'000), disc(16'000)), std::pair(side(8'000), side(16'000))}) {
            const auto forFew = double(listed(few, angle)), forMany = double(listed(many, angle));
            QVERIFY2(forMany < 2.3 * forFew && forMany < 100 * double(many.size()),
                     QByteArray::number(forMany / forFew));
        }
    }

    void aSegmentAcrossADiscPassesFewLeaves()
    {
        Random random(4);
        const auto perSegment = [&](int corners) {
            const auto edges = edgesOf({{{{disc(corners)}}}});
            const EdgeTree tree(edges, 1, boxOf(edges));
            const auto any = [&] { return edges[std::size_t(random.whole(0, corners - 1))]; };
            std::size_t count = 0;
            constexpr int segments = 2'000;
            for (int i = 0; i < segments; ++i)
                tree.trace({any().segment.a, any().segment.a},
                           [&](const auto& near) { count += near.size(); });
            return double(count) / segments;
        };
        const double few = perSegment(8'000), many = perSegment(64'000);
        QVERIFY2(many < 300 && many < 1.6 * few,
                 QByteArray::number(few) + ' ' + QByteArray::number(many));
    }

    void aBoxThatIsTooSmallOrTooLargeHasNone()
    {
        QVERIFY(EdgeTree::suits({{0, 0}, {1, 0}}) && EdgeTree::suits({{1e300, 0}, {1e300, 1e-9}}));
        QVERIFY(!EdgeTree::suits({{0, 0}, {1e-200, 1e-200}}));
        QVERIFY(!EdgeTree::suits({{0, 0}, {1e200, 1}}));
        QVERIFY(!EdgeTree::suits({{1, 1}, {1, 1}}));
    }
};

} // namespace region_edge_tree_test

TEST_CLASS(region_edge_tree_test::EdgeTreeTest, Core)
#include "tests/clipping/region/edge_tree_test.moc"

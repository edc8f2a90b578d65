// SPDX-License-Identifier: GPL-3.0-or-later
// A region that is one convex area is clipped at by the vector kernel for polygons: with the same
// pieces, bit for bit, edge numbers included, as edge by edge.
#include "clipping/region/catalogue.h"
#include "clipping/region/prepared.h"
#include "clipping/turned_window.h"

#include <QTest>

#include "tests/clipping/polygon/shapes.h"
#include "tests/clipping/region/contract.h"
#include "tests/clipping/region/shapes.h"
#include "tests/test_class.h"

namespace region_convex_test {

using namespace clipping;

namespace {

bool isSame(const RegionPiece& p, const RegionPiece& q)
{
    return sameBits(p.segment, q.segment) && p.source == q.source && p.edgeOfA == q.edgeOfA
           && p.edgeOfB == q.edgeOfB;
}

/// By an output of that size, again and again.
std::vector<RegionPiece> clippedAll(const std::vector<Segment>& lines, const PreparedRegion& region,
                                    std::size_t room)
{
    std::vector<RegionPiece> all, out(room);
    for (RegionProgress at; at.segment < lines.size();) {
        at = clipAll(lines, region, out, at);
        all.insert(all.end(), out.begin(), out.begin() + std::ptrdiff_t(at.written));
    }
    return all;
}

std::vector<RegionPiece> edgeByEdge(const std::vector<Segment>& lines, const PreparedRegion& region)
{
    std::vector<RegionPiece> all(lines.size() + 1);
    all.resize(findRegionAlgorithm("winding-number")->clipAll(lines, region, all, {}).written);
    return all;
}

void compare(const Area& area, const std::vector<Segment>& lines)
{
    const PreparedRegion region({{{area}}, Keep::Inside});
    const auto expected = edgeByEdge(lines, region);
    for (const std::size_t room : {lines.size(), std::size_t(7)}) {
        const auto found = clippedAll(lines, region, room);
        if (std::ranges::equal(found, expected, isSame))
            continue;
        for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i)
            if (!isSame(found[i], expected[i]))
                QFAIL(exactly(lines[expected[i].source], {{{area}}, Keep::Inside}).c_str());
        QFAIL("more or fewer pieces");
    }
}

/// Segments between points at, on and near the polygon and anywhere.
std::vector<Segment> linesAt(const std::vector<glm::dvec2>& corners, RandomNumbers& random,
                             double size)
{
    std::vector<glm::dvec2> points = corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto &p = corners[i], &q = corners[(i + 1) % corners.size()];
        points.push_back(p / 2.0 + q / 2.0);
        points.push_back(2.0 * p - q);
        points.push_back({nudged(p.x, random.integer(-1, 1)), nudged(q.y, random.integer(-1, 1))});
        points.push_back({nudged(p.x, random.integer(-2, 2)), nudged(p.y, random.integer(-2, 2))});
    }
    for (int i = 0; i < 8; ++i) {
        const double x = random.uniform(-2, 2);
        points.push_back(size * glm::dvec2(x, random.uniform(-2, 2)));
    }
    std::vector<Segment> lines{{{NAN, 0}, {1, 1}}, {{0, 0}, {INFINITY, 1}}};
    for (int i = 0; i < 200; ++i) {
        const auto last = int(points.size()) - 1;
        const auto p = points[std::size_t(random.integer(0, last))];
        lines.push_back({p, points[std::size_t(random.integer(0, last))]});
    }
    return lines;
}

bool isConvex(const Area& area, Keep keep = Keep::Inside)
{
    return PreparedRegion({{{area}}, keep}).data().convex != nullptr;
}

} // namespace

class ConvexTest : public QObject {
    Q_OBJECT

private slots:
    void randomPolygons()
    {
        RandomNumbers random(41);
        int convex = 0;
        for (int i = 0; i < 400; ++i) {
            const double size = std::array{1.0, 100.0, 0x1p-200, 1e6, 3.0}[std::size_t(i % 5)];
            auto corners = somePolygon(random, random.integer(3, i % 50 ? 12 : 200), size).corners;
            if (corners.size() < 3)
                continue;
            const auto lines = linesAt(corners, random, size);
            std::rotate(corners.begin(), corners.begin() + random.integer(0, 2), corners.end());
            if (random.integer(0, 1))
                std::ranges::reverse(corners);
            convex += isConvex({corners});
            compare({corners}, lines);
        }
        QVERIFY(convex > 300);
    }
    void polygonsOfAGrid()
    {
        RandomNumbers random(42);
        for (int i = 0; i < 600; ++i) {
            std::vector<glm::dvec2> points;
            for (int n = random.integer(3, 6); n > 0; --n) {
                const double x = random.integer(-3, 3);
                points.push_back({x, random.integer(-3, 3)});
            }
            auto corners = hullOf(points).corners;
            if (corners.size() < 3)
                continue;
            if (random.integer(0, 1))
                std::ranges::reverse(corners);
            compare({corners}, linesAt(corners, random, 2));
        }
    }
    void windows()
    {
        RandomNumbers random(43);
        for (const auto& [name, window, segments] : hardScenes<double>(500))
            for (const double degrees : {0.0, 30.0, 90.0})
                compare({cornersOf(turned(window, degrees)).corners}, segments);
    }
    void onlyTheFirstRingCounts()
    {
        const Area square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {9, 9}, {7, 7}}, {4}};
        QVERIFY(isConvex(square));
        RandomNumbers random(44);
        compare(square, linesAt({square.points.begin(), square.points.begin() + 4}, random, 4));
    }
    void allElseIsSwept()
    {
        QVERIFY(isConvex(areaOf({{0, 0}, {2, 2}})));
        QVERIFY(!isConvex(areaOf({{0, 0}, {2, 2}}), Keep::Outside));
        const auto first = [](AreaOperation operation) {
            const Region region{{{areaOf({{0, 0}, {2, 2}}), operation}}, Keep::Inside};
            return PreparedRegion(region).data().convex != nullptr;
        };
        QVERIFY(first(AreaOperation::Intersect));
        QVERIFY(!first(AreaOperation::CutOut));
        QVERIFY(!isConvex({{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}));         // concave
        QVERIFY(!isConvex({{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}})); // a straight corner
        QVERIFY(!isConvex({{{0, 0}, {4, 0}, {4, 0}, {0, 4}}}));         // a repeated one
        QVERIFY(!isConvex({{{0, 0}, {4, 4}, {2, 2}}}));                 // without area
        QVERIFY(!isConvex({{{0, 0}, {4, 0}, {4, NAN}}}));
        QVERIFY(!isConvex({{{0, 0}, {4, 0}, {0, 4}, {0, 0}, {4, 0}, {0, 4}}, {3, 6}}));
        QVERIFY(!isConvex({{{0, 0}, {0x1p900, 0}, {0, 0x1p900}}})); // the kernel would overflow
    }
};

} // namespace region_convex_test

TEST_CLASS(region_convex_test::ConvexTest, Core)
#include "tests/clipping/region/convex_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Areas on small grids, among them all degenerate and self-crossing ones, against fractions: the
// contract of clipping/region/region.h.
#include "clipping/region/grid.h"

#include <QTest>

#include "tests/clipping/random.h"
#include "tests/clipping/region/contract.h"
#include "tests/clipping/region/in_tree.h"
#include "tests/test_class.h"

namespace region_grid_test {

using namespace clipping;

namespace {

using Truth = region_oracle::Truth<region_oracle::SmallFraction>;

glm::dvec2 gridPoint(int index, int side) { return {index % side, index / side}; }

/// Every segment between points of a grid; those that are reversed are checked along with these.
std::vector<Segment> gridSegments(int side)
{
    std::vector<Segment> all;
    for (int i = 0; i < side * side; ++i)
        for (int j = i; j < side * side; ++j)
            all.push_back({gridPoint(i, side), gridPoint(j, side)});
    return all;
}

void check(const Region& region, std::span<const Segment> segments)
{
    const Truth truth(region);
    const PreparedRegion prepared(region), other = inTree(region);
    for (const Segment& s : segments) {
        if (const auto wrong = faultAt(s, truth, prepared); !wrong.empty())
            QFAIL((wrong + " for " + exactly(s, region)).c_str());
        QVERIFY2(arePieces(clip(s, other), clip(s, prepared)), exactly(s, region).c_str());
    }
}

Region single(std::vector<glm::dvec2> points, FillRule rule = FillRule::NonZero)
{
    return {{{{std::move(points), {}, rule}, AreaOperation::Add}}, Keep::Inside};
}

/// Every ring of so many points of a grid, by its number.
std::vector<glm::dvec2> ringOf(long number, int points, int side)
{
    std::vector<glm::dvec2> ring;
    for (int i = 0; i < points; ++i, number /= side * side)
        ring.push_back(gridPoint(int(number % (side * side)), side));
    return ring;
}

Area someArea(Random& random, int side)
{
    Area area{{}, {}, random.whole(0, 1) ? FillRule::NonZero : FillRule::EvenOdd};
    for (int ring = random.whole(0, 2); ring >= 0; --ring) {
        for (int i = random.whole(1, 6); i > 0; --i)
            area.points.push_back(gridPoint(random.whole(0, side * side - 1), side));
        area.ringEnds.push_back(std::uint32_t(area.points.size()));
    }
    if (area.ringEnds.size() == 1 && random.whole(0, 1))
        area.ringEnds.clear();
    return area;
}

std::vector<Segment> someSegments(Random& random, int side, int count)
{
    std::vector<Segment> all;
    const auto point = [&] { return glm::dvec2(random.whole(-1, side), random.whole(-1, side)); };
    for (int i = 0; i < count; ++i) {
        const auto a = point();
        all.push_back({a, random.whole(0, 9) == 0 ? a : point()});
    }
    return all;
}

} // namespace

class GridTest : public QObject {
    Q_OBJECT

private slots:
    // Each edge spans the whole height, and would be listed in each row.
    void anAreaWithoutWidthListsFewEdges()
    {
        std::vector<AreaEdge> edges;
        for (std::uint32_t i = 0; i < 4000; ++i)
            edges.push_back({{{1, i % 2}, {1, 1 - i % 2}}, 0, i});
        const SearchGrid grid(edges, 1, 300, 64);
        const std::size_t listed = grid.edgesIn(0, grid.cells() - 1).size();
        QVERIFY(listed >= edges.size());
        QVERIFY2(listed < 2 * (0x1p20 + 64. * double(edges.size())),
                 QByteArray::number(qulonglong(listed)));
    }

    void everyTriangle()
    {
        const auto segments = gridSegments(3);
        for (long i = 0; i < 9 * 9 * 9 && !QTest::currentTestFailed(); ++i)
            check(single(ringOf(i, 3, 3)), segments);
    }

    void everyQuadrilateral()
    {
        const auto segments = gridSegments(3);
        for (long i = 0; i < 9 * 9 * 9 * 9 && !QTest::currentTestFailed(); ++i)
            check(single(ringOf(i, 4, 3), i % 2 ? FillRule::NonZero : FillRule::EvenOdd), segments);
    }

    void trianglesAndQuadrilateralsOfALargerGrid()
    {
        Random random(1);
        for (int i = 0; i < 8'000 && !QTest::currentTestFailed(); ++i) {
            const long triangle = random.whole(0, 16 * 16 * 16 - 1);
            const long quadrilateral = random.whole(0, 16 * 16 * 16 * 16 - 1);
            check(single(i % 2 ? ringOf(triangle, 3, 4) : ringOf(quadrilateral, 4, 4)),
                  someSegments(random, 4, 10));
        }
    }

    void areasOfSeveralRings()
    {
        Random random(2);
        for (int i = 0; i < 3'000 && !QTest::currentTestFailed(); ++i)
            check({{{someArea(random, 5), AreaOperation::Add}}, Keep::Inside},
                  someSegments(random, 5, 10));
    }

    void severalAreasTogether()
    {
        Random random(3);
        int pieces = 0, contacts = 0, several = 0;
        for (int i = 0; i < 3'000 && !QTest::currentTestFailed(); ++i) {
            Region region{{}, random.whole(0, 1) ? Keep::Inside : Keep::Outside};
            for (int n = random.whole(0, 5); n > 0; --n)
                region.steps.push_back({someArea(random, 6), AreaOperation(random.whole(0, 2))});
            const auto segments = someSegments(random, 6, 8);
            check(region, segments);
            const PreparedRegion prepared(region);
            for (const Segment& s : segments) {
                const auto found = clip(s, prepared);
                pieces += int(found.size());
                several += found.size() > 1;
                contacts += int(std::ranges::count_if(found, [&](const RegionPiece& p) {
                    return p.segment.a == p.segment.b && s.a != s.b;
                }));
            }
        }
        QVERIFY(pieces > 10'000 && several > 2'000 && contacts > 500);
    }
};

} // namespace region_grid_test

TEST_CLASS(region_grid_test::GridTest, Core)
#include "tests/clipping/region/grid_test.moc"

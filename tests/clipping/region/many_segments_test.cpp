// SPDX-License-Identifier: GPL-3.0-or-later
// Many segments at once, for which a region gets smaller cells, against one after another, which
// the other tests compare with fractions.
#include "clipping/region/region.h"

#include <QTest>

#include <cstring>

#include "tests/clipping/region/shapes.h"
#include "tests/test_class.h"

namespace region_many_segments_test {

using namespace clipping;

namespace {

constexpr std::size_t many = 4'200; // enough for smaller cells

std::vector<Segment> someSegments(Random& random, HostilePoints& points)
{
    std::vector<Segment> all;
    while (all.size() < many) {
        const glm::dvec2 a = points.next(), b = random.whole(0, 9) == 0 ? a : points.next();
        all.push_back({a, random.whole(0, 1) ? b : a + (b - a) * random.unit()});
        if (random.whole(0, 99) == 0)
            (random.whole(0, 1) ? all.back().a : all.back().b).x =
                random.of(std::array<double, 2>{NAN, INFINITY});
    }
    return all;
}

bool areSame(const RegionPiece& p, const RegionPiece& q)
{
    return std::memcmp(&p.segment, &q.segment, sizeof p.segment) == 0 && p.source == q.source
           && p.edgeOfA == q.edgeOfA && p.edgeOfB == q.edgeOfB;
}

std::vector<RegionPiece> oneByOne(std::span<const Segment> segments, const PreparedRegion& region)
{
    std::vector<RegionPiece> all;
    for (std::size_t i = 0; i < segments.size(); ++i)
        for (RegionPiece piece : clip(segments[i], region)) {
            piece.source = std::uint32_t(i);
            all.push_back(piece);
        }
    return all;
}

/// With buffers of a size.
std::vector<RegionPiece> together(std::span<const Segment> segments, const PreparedRegion& region,
                                  std::size_t size)
{
    std::vector<RegionPiece> all, buffer(size);
    for (RegionProgress at; at.segment < segments.size();) {
        at = clipAll(segments, region, buffer, at);
        all.insert(all.end(), buffer.begin(), buffer.begin() + std::ptrdiff_t(at.written));
    }
    return all;
}

void check(const Region& region, std::span<const Segment> segments)
{
    const PreparedRegion prepared(region);
    const auto expected = oneByOne(segments, prepared);
    for (const std::size_t size : {3 * many, many, std::size_t(7)})
        QVERIFY(std::ranges::equal(expected, together(segments, prepared, size), areSame));
}

} // namespace

class ManySegmentsTest : public QObject {
    Q_OBJECT

private slots:
    void areClippedAsOneByOne_data()
    {
        QTest::addColumn<bool>("ordinary");
        QTest::newRow("ordinary numbers") << true;
        QTest::newRow("any numbers") << false;
    }
    void areClippedAsOneByOne()
    {
        QFETCH(bool, ordinary);
        Random random(11);
        for (int i = 0; i < (ordinary ? 5 : 1) && !QTest::currentTestFailed(); ++i) {
            HostilePoints points(random, ordinary);
            const Region region = hostileRegion(random, points, 4);
            check(region, someSegments(random, points));
        }
    }
    void withoutEdgesAllOrNothingIsKept()
    {
        const std::vector<Segment> segments(many, {{0, 0}, {1, 1}});
        check({}, segments);
        check({{{Area{}}}}, segments);
        check({{{Area{}}}, Keep::Outside}, segments);
    }
};

} // namespace region_many_segments_test

TEST_CLASS(region_many_segments_test::ManySegmentsTest, Core)
#include "tests/clipping/region/many_segments_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// What every row that clips at regions keeps when its pieces are used again: cutting twice changes
// next to nothing, and what is inside and what is outside add up to the whole. For rotated
// rectangles, circles and stars.
//
// Bounds, in ulps of M, the largest |coordinate| of segment and region. A new end is off the exact
// one by half an ulp on each axis, so by 0.71 ulps; and as far at most off the edge that cut it. A
// piece that meets this edge at an angle whose sine is at least 1/8 leaves the edge's other side
// after 8 * 0.71 = 5.7 ulps; the second cut is rounded as well, by half an ulp on each axis: 7. At
// a smaller angle the end may move further, along the edge.
//
// In lengths, an end that is off the segment by 0.71 ulps makes a detour of at most twice that; the
// length of a piece is computed from two differences, squares, a sum and a root, off by less than
// 4e of at most 2.83 M: 6 ulps. Both together are less than 8 ulps for each piece.
#include "clipping/region/catalogue.h"
#include "clipping/turned_window.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/clipping/random.h"
#include "tests/clipping/region/contract.h"
#include "tests/clipping/scenes.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace region_twice_test {

using namespace clipping;


namespace {

constexpr double mostMoved = 7, mostOffInLength = 8, smallestSine = 0.125;

Area regular(int corners, double radius, const glm::dvec2& centre, int step = 1)
{
    Area area;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i * step / corners + 0.1;
        area.points.push_back(centre + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return area;
}

struct Shape {
    const char* name;
    Area area;
};

std::vector<Shape> shapes()
{
    Area evenOddStar = regular(7, 200, {-30, 40}, 3), spikes = regular(40, 250, {0, 0});
    evenOddStar.rule = FillRule::EvenOdd;
    for (std::size_t i = 0; i < spikes.points.size(); i += 2)
        spikes.points[i] *= 0.4;
    return {{"rotated by 30 degrees", {cornersOf({{10, -20}, {150, 90}, 30}).corners}},
            {"rotated by 77.7 degrees", {cornersOf({{0.3, 0.7}, {210, 11}, 77.7}).corners}},
            {"circle of 64 edges", regular(64, 180, {1.0 / 3, -1.0 / 7})},
            {"circle of 1,000 edges", regular(1'000, 180, {1000, 1000})},
            {"star", regular(5, 220, {0, 0}, 2)},
            {"star by the even-odd rule", evenOddStar},
            {"star of 20 points", spikes}};
}

/// Segments of all lengths around an area.
std::vector<Segment> linesAt(const Area& area, std::size_t count)
{
    RandomNumbers random(51);
    std::vector<Segment> lines;
    const auto& points = area.points;
    while (lines.size() < count) {
        const auto& near = points[std::size_t(random.integer(0, int(points.size()) - 1))];
        const auto anywhere = [&](double reach) {
            const double x = random.uniform(-reach, reach);
            return near + glm::dvec2(x, random.uniform(-reach, reach));
        };
        const glm::dvec2 a = anywhere(400);
        lines.push_back({a, random.integer(0, 1) ? anywhere(400) : a + (anywhere(9) - near)});
    }
    return lines;
}

/// An ulp of M.
double ulpOf(const Segment& s, const Area& area)
{
    double most = 0;
    for (const auto& p : area.points)
        most = std::max({most, std::abs(p.x), std::abs(p.y)});
    for (const auto& p : {s.a, s.b})
        most = std::max({most, std::abs(p.x), std::abs(p.y)});
    return std::ldexp(1.0, std::ilogb(most) - 52);
}

double length(const Segment& s) { return std::hypot(s.b.x - s.a.x, s.b.y - s.a.y); }

/// Whether a segment meets the edge with that number at an angle that is not small, or none.
bool isSteep(const Segment& s, std::uint32_t number, const PreparedRegion& region)
{
    if (number == 0)
        return true;
    const Segment edge = region.edge(number).segment;
    const glm::dvec2 d = s.b - s.a, e = edge.b - edge.a;
    return std::abs(d.x * e.y - d.y * e.x) >= smallestSine * length(s) * length(edge);
}

double moved(const glm::dvec2& p, const glm::dvec2& q)
{
    return std::max(std::abs(p.x - q.x), std::abs(p.y - q.y));
}

void everyRowAndShape()
{
    QTest::addColumn<const RegionAlgorithm*>("row");
    QTest::addColumn<int>("shape");
    const auto all = shapes();
    for (const RegionAlgorithm& row : regionAlgorithms())
        for (std::size_t i = 0; i < all.size(); ++i)
            QTest::addRow("%s, %s", row.key.data(), all[i].name) << &row << int(i);
}

} // namespace

class TwiceTest : public QObject {
    Q_OBJECT

private slots:
    void cuttingTwiceChangesNextToNothing_data() { everyRowAndShape(); }
    void cuttingTwiceChangesNextToNothing()
    {
        QFETCH(const RegionAlgorithm*, row);
        QFETCH(int, shape);
        const Area area = shapes()[std::size_t(shape)].area;
        int cut = 0;
        for (const Keep keep : {Keep::Inside, Keep::Outside}) {
            const Region region{{{area}}, keep};
            const PreparedRegion prepared(region);
            for (const Segment& s : linesAt(area, 1'500))
                for (const RegionPiece& piece : row->clip(s, prepared)) {
                    if (!isSteep(s, piece.edgeOfA, prepared)
                        || !isSteep(s, piece.edgeOfB, prepared))
                        continue;
                    const auto again = row->clip(piece.segment, prepared);
                    VERIFY_OR_SAY(again.size() == 1, exactly(s, region).c_str());
                    const double most = mostMoved * ulpOf(s, area);
                    VERIFY_OR_SAY(moved(again[0].segment.a, piece.segment.a) <= most
                                      && moved(again[0].segment.b, piece.segment.b) <= most,
                                  exactly(s, region).c_str());
                    cut += piece.edgeOfA != 0 || piece.edgeOfB != 0;
                }
        }
        QVERIFY(cut > 500);
    }

    void insideAndOutsideAddUp_data() { everyRowAndShape(); }
    void insideAndOutsideAddUp()
    {
        QFETCH(const RegionAlgorithm*, row);
        QFETCH(int, shape);
        const Area area = shapes()[std::size_t(shape)].area;
        const PreparedRegion inside({{{area}}, Keep::Inside}), outside({{{area}}, Keep::Outside});
        for (const Segment& s : linesAt(area, 3'000)) {
            double sum = 0;
            std::size_t pieces = 0;
            for (const PreparedRegion* region : {&inside, &outside})
                for (const RegionPiece& piece : row->clip(s, *region))
                    sum += length(piece.segment), ++pieces;
            const double most = mostOffInLength * double(pieces) * ulpOf(s, area);
            VERIFY_OR_SAY(std::abs(sum - length(s)) <= most, exactly(s, {{{area}}}).c_str());
        }
    }
};

} // namespace region_twice_test

TEST_CLASS(region_twice_test::TwiceTest, Core)
#include "tests/clipping/region/twice_test.moc"

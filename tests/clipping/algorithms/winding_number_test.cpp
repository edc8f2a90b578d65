// SPDX-License-Identifier: GPL-3.0-or-later
// What the row winding-number promises beyond the contract: it is exact. So its results are those
// of `exact`, at windows and at regions.
#include "clipping/algorithm.h"
#include "clipping/region/catalogue.h"

#include <QTest>

#include "tests/clipping/contract.h"
#include "tests/clipping/random.h"
#include "tests/clipping/region/contract.h"
#include "tests/clipping/region/shapes.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace algorithms_winding_number_test {

using namespace clipping;

namespace {

const Algorithm& row() { return *findAlgorithm("winding-number"); }

const RegionAlgorithm& regionRow() { return *findRegionAlgorithm("winding-number"); }

bool isSame(const RegionPiece& p, const RegionPiece& q)
{
    return sameBits(p.segment, q.segment) && p.source == q.source && p.edgeOfA == q.edgeOfA
           && p.edgeOfB == q.edgeOfB;
}

/// A random segment on the grid around a random region.
Segment someSegment(HostilePoints& points)
{
    const glm::dvec2 a = points.next();
    return {a, points.next()};
}

} // namespace

class WindingNumberTest : public QObject {
    Q_OBJECT

private slots:
    // -0 equals 0: at a corner the two rows may name different edges.
    void windowsAreClippedAsByExact()
    {
        for (const Family& family : families()) {
            const auto& inputs = family.inputs();
            for (std::size_t i = 0; i < inputs.size(); i += inputs.size() / 50'000 + 1)
                if (row().corrected.clip(inputs[i].segment, inputs[i].window)
                    != exactAlgorithm().corrected.clip(inputs[i].segment, inputs[i].window))
                    QFAIL(exactly(inputs[i]).c_str());
        }
    }
    void theGridToo()
    {
        for (const Input& input : grid())
            if (row().corrected.clip(input.segment, input.window)
                != exactAlgorithm().corrected.clip(input.segment, input.window))
                QFAIL(exactly(input).c_str());
    }
    void reversedSegmentsGiveReversedPieces()
    {
        for (const Input& input : grid()) {
            const auto& [s, w] = input;
            const auto piece = row().corrected.clip(s, w);
            const auto back = row().corrected.clip({s.b, s.a}, w);
            QCOMPARE(piece.has_value(), back.has_value());
            QVERIFY(!piece || (piece->a == back->b && piece->b == back->a));
        }
    }

    void regionsAreClippedAsByExact()
    {
        Random random(31);
        for (int i = 0; i < 1'500; ++i) {
            HostilePoints points(random, i % 4 != 0);
            const Region region = hostileRegion(random, points, 3);
            const PreparedRegion prepared(region);
            for (int j = 0; j < 12; ++j) {
                const Segment s = someSegment(points);
                const auto found = regionRow().clip(s, prepared);
                VERIFY_OR_SAY(std::ranges::equal(found, clip(s, prepared), isSame),
                              exactly(s, region).c_str());
            }
        }
    }
    void segmentsThatAreNotFiniteAreInNoArea()
    {
        const Area square = areaOf({{0, 0}, {2, 2}});
        const Segment line{{1, NAN}, {INFINITY, 1}};
        QVERIFY(regionRow().clip(line, PreparedRegion({{{square}}, Keep::Inside})).empty());
        QCOMPARE(regionRow().clip(line, PreparedRegion({{{square}}, Keep::Outside})).size(), 1u);
    }
    void aFullBufferIsContinued()
    {
        const Area comb{{{0, 0},
                         {9, 0},
                         {9, 9},
                         {7, 9},
                         {7, 2},
                         {5, 2},
                         {5, 9},
                         {3, 9},
                         {3, 2},
                         {1, 2},
                         {1, 9},
                         {0, 9}}};
        const PreparedRegion region({{{comb}}, Keep::Inside});
        const std::vector<Segment> lines{
            {{-1, 5}, {10, 5}}, {{20, 0}, {30, 0}}, {{10, 4}, {-1, 4}}};
        std::vector<RegionPiece> all;
        std::array<RegionPiece, 1> buffer;
        for (RegionProgress at; at.segment < lines.size();) {
            at = regionRow().clipAll(lines, region, buffer, at);
            all.insert(all.end(), buffer.begin(), buffer.begin() + long(at.written));
        }
        std::vector<RegionPiece> expected(10);
        expected.resize(clipAll(lines, region, expected).written);
        QCOMPARE(expected.size(), 6u);
        QVERIFY(std::ranges::equal(all, expected, isSame));
    }
};

} // namespace algorithms_winding_number_test

TEST_CLASS(algorithms_winding_number_test::WindingNumberTest, Core)
#include "tests/clipping/algorithms/winding_number_test.moc"

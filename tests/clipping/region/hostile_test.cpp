// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of clipping/region/region.h for numbers that are hard to decide, against fractions;
// and input that is no area.
#include "clipping/region/region.h"

#include <QTest>

#include <numbers>

#include "tests/clipping/region/contract.h"
#include "tests/clipping/region/in_tree.h"
#include "tests/clipping/region/shapes.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace region_hostile_test {

using namespace clipping;

namespace {

using Truth = region_oracle::Truth<Rational>;

void check(unsigned seed, bool ordinary, int regions, int areas)
{
    Random random(seed);
    int pieces = 0;
    for (int i = 0; i < regions; ++i) {
        HostilePoints points(random, ordinary);
        const Region region = hostileRegion(random, points, areas);
        const Truth truth(region);
        const PreparedRegion prepared(region), other = inTree(region);
        for (int j = 0; j < 6; ++j) {
            const glm::dvec2 a = points.next(), b = points.next();
            if (const auto wrong = faultAt({a, b}, truth, prepared); !wrong.empty())
                QFAIL((wrong + " for " + exactly({a, b}, region)).c_str());
            QVERIFY2(arePieces(clip({a, b}, other), clip({a, b}, prepared)),
                     exactly({a, b}, region).c_str());
            pieces += int(clip({a, b}, prepared).size());
        }
    }
    QVERIFY(pieces > regions);
}

std::vector<Segment> segmentsOf(const std::vector<RegionPiece>& pieces)
{
    std::vector<Segment> all;
    for (const RegionPiece& piece : pieces)
        all.push_back(piece.segment);
    return all;
}

std::vector<glm::dvec2> star(int points, int step)
{
    std::vector<glm::dvec2> all;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i * step / points;
        all.push_back({std::cos(angle), std::sin(angle)});
    }
    return all;
}

} // namespace

class HostileTest : public QObject {
    Q_OBJECT

private slots:
    void nearlyCollinear() { check(1, true, 1'000, 1); }
    void fiveNearlyCollinear() { check(3, true, 150, 5); }
    void anySize() { check(2, false, 20, 1); } // fractions of thousands of bits

    // Nothing but the exponents may differ: all decisions and roundings are exact.
    void scalingAnAxisChangesNothing()
    {
        Random random(7);
        for (int i = 0; i < 2'000; ++i) {
            HostilePoints points(random, true);
            const Region region = hostileRegion(random, points, 3);
            const int x = random.whole(-800, 800), y = random.whole(-800, 800);
            const auto scaled = [&](const glm::dvec2& p) {
                return glm::dvec2(std::ldexp(p.x, x), std::ldexp(p.y, y));
            };
            Region other = region;
            for (auto& step : other.steps)
                std::ranges::transform(step.area.points, step.area.points.begin(), scaled);
            const PreparedRegion prepared(region), otherPrepared(other);
            for (int j = 0; j < 6; ++j) {
                const Segment s{points.next(), points.next()};
                auto expected = clip(s, prepared);
                for (RegionPiece& piece : expected)
                    piece.segment = {scaled(piece.segment.a), scaled(piece.segment.b)};
                VERIFY_OR_SAY(arePieces(clip({scaled(s.a), scaled(s.b)}, otherPrepared), expected),
                              exactly(s, region).c_str());
            }
        }
    }

    void areasThatAreNotFiniteContainNothing()
    {
        const Segment line{{-1, 0.25}, {2, 0.25}};
        for (const double bad : {INFINITY, -INFINITY, NAN}) {
            const Area area{{{0, 0}, {1, 0}, {1, bad}, {0, 1}}};
            QVERIFY(clip(line, PreparedRegion({{{area}}, Keep::Inside})).empty());
            const auto outside = clip(line, PreparedRegion({{{area}}, Keep::Outside}));
            QCOMPARE(segmentsOf(outside), std::vector{line});
            const Area whole{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
            const PreparedRegion both({{{area}, {whole}}, Keep::Inside});
            const auto pieces = clip(line, both);
            QCOMPARE(segmentsOf(pieces), std::vector{(Segment{{0, 0.25}, {1, 0.25}})});
            QCOMPARE(pieces[0].edgeOfA, 8u); // counted with the points of the other area
            QCOMPARE(both.edge(8).step, 1u);
            QCOMPARE(both.edge(8).segment, (Segment{{0, 1}, {0, 0}}));
        }
    }
    void segmentsThatAreNotFiniteAreInNoArea()
    {
        const Region square{{{areaOf({{0, 0}, {1, 1}})}}, Keep::Inside};
        for (const double bad : {INFINITY, NAN}) {
            const Segment line{{0.5, 0.5}, {bad, 0.5}};
            QVERIFY(clip(line, PreparedRegion(square)).empty());
            const auto outside = clip(line, PreparedRegion({square.steps, Keep::Outside}));
            QCOMPARE(outside.size(), 1u);
            QVERIFY(sameBits(outside[0].segment, line));
        }
    }
    void whatHasNoAreaContributesNothing()
    {
        const Segment line{{-3, 0}, {3, 0}};
        for (const auto& points :
             std::vector<std::vector<glm::dvec2>>{{},
                                                  {{0, 0}},
                                                  {{0, 0}, {0, 0}, {0, 0}},
                                                  {{-1, 0}, {1, 0}},
                                                  {{0, -1}, {0, 1}},
                                                  {{-1, -1}, {0, 0}, {1, 1}, {0, 0}}})
            for (const FillRule rule : {FillRule::NonZero, FillRule::EvenOdd}) {
                const Area area{points, {}, rule};
                QVERIFY(clip(line, PreparedRegion({{{area}}, Keep::Inside})).empty());
                QVERIFY(clip({{0, 0}, {0, 0}}, PreparedRegion({{{area}}, Keep::Inside})).empty());
                QCOMPARE(segmentsOf(clip(line, PreparedRegion({{{area}}, Keep::Outside}))),
                         std::vector{line});
            }
    }
    void repeatedPointsChangeNothing()
    {
        const Region plain{{{{{{0, 0}, {4, 1}, {3, 5}, {2, 2}}}}}, Keep::Inside};
        const Region repeated{
            {{{{{0, 0}, {0, 0}, {4, 1}, {3, 5}, {3, 5}, {3, 5}, {2, 2}, {0, 0}}}}}, Keep::Inside};
        Random random(5);
        for (int i = 0; i < 1'000; ++i) {
            const Segment s{{random.whole(-1, 6), random.whole(-1, 6)},
                            {random.whole(-1, 6), random.whole(-1, 6)}};
            QCOMPARE(segmentsOf(clip(s, PreparedRegion(plain))),
                     segmentsOf(clip(s, PreparedRegion(repeated))));
        }
    }
    void noSteps()
    {
        const Segment line{{0, 0}, {1, 2}};
        for (const Keep keep : {Keep::Inside, Keep::Outside})
            QCOMPARE(segmentsOf(clip(line, PreparedRegion({{}, keep}))), std::vector{line});
    }

    // 100,000 edges through the middle, each of which crosses all others.
    void manyLongEdges()
    {
        const Region region{{{{star(100'001, 50'000), {}, FillRule::EvenOdd}}}, Keep::Inside};
        const PreparedRegion prepared(region);
        const Segment line{{-2, 0.05}, {2, 0.06}};
        const auto pieces = clip(line, prepared);
        QVERIFY(pieces.size() > 10'000);
        for (std::size_t i = 1; i < pieces.size(); ++i)
            QVERIFY(pieces[i - 1].segment.b.x <= pieces[i].segment.a.x);
        const auto nonZero =
            clip(line, PreparedRegion({{{{star(100'001, 50'000)}}}, Keep::Inside}));
        // The tips merge within a third of the radius.
        QVERIFY(std::ranges::any_of(nonZero, [](const RegionPiece& piece) {
            return piece.segment.a.x < -0.3 && piece.segment.b.x > 0.3;
        }));
    }

    // An area as wide as 2^-900 and as high as 2^900 is prepared and clipped at as any other.
    void extremeExtents()
    {
        const auto scaled = [](const glm::dvec2& p) {
            return glm::dvec2(std::ldexp(p.x, -900), std::ldexp(p.y, 900));
        };
        Region region{{{{star(20'001, 7)}}}, Keep::Inside};
        const Segment line{{-2, 0.3}, {0.1, 0.31}};
        auto expected = clip(line, PreparedRegion(region));
        QCOMPARE(expected.size(), 1u);
        auto& points = region.steps[0].area.points;
        std::ranges::transform(points, points.begin(), scaled);
        for (RegionPiece& piece : expected)
            piece.segment = {scaled(piece.segment.a), scaled(piece.segment.b)};
        QVERIFY(
            arePieces(clip({scaled(line.a), scaled(line.b)}, PreparedRegion(region)), expected));
    }

    void everySizeOfBufferGivesTheSame()
    {
        Random random(6);
        for (int i = 0; i < 100; ++i) {
            HostilePoints points(random, true);
            const PreparedRegion region(hostileRegion(random, points, 3));
            std::vector<Segment> lines;
            for (int j = 0; j < 20; ++j)
                lines.push_back({points.next(), points.next()});
            std::vector<RegionPiece> expected;
            for (std::size_t j = 0; j < lines.size(); ++j)
                for (RegionPiece piece : clip(lines[j], region)) {
                    piece.source = std::uint32_t(j);
                    expected.push_back(piece);
                }
            for (const std::size_t size : {1, 2, 3, 5, 8, 13, 1'000}) {
                std::vector<RegionPiece> out(size), all;
                RegionProgress progress;
                do {
                    progress = clipAll(lines, region, out, progress);
                    QVERIFY(progress.written == size || progress.segment == lines.size());
                    const auto written = std::span(out).first(progress.written);
                    all.insert(all.end(), written.begin(), written.end());
                } while (progress.segment < lines.size());
                QVERIFY(arePieces(all, expected));
                QVERIFY(std::ranges::equal(all, expected, {}, &RegionPiece::source,
                                           &RegionPiece::source));
            }
        }
    }
};

} // namespace region_hostile_test

TEST_CLASS(region_hostile_test::HostileTest, Core)
#include "tests/clipping/region/hostile_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of clipping/area/clip_area.h for numbers that are hard to decide, against fractions;
// and input that is refused.
#include <QTest>

#include "tests/clipping/area/contract.h"
#include "tests/clipping/area/shapes.h"
#include "tests/clipping/area/truth.h"
#include "tests/clipping/region/contract.h"
#include "tests/clipping/region/in_tree.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace area_hostile_test {

using namespace clipping;
using namespace area_contract;

namespace {

using Truth = AreaTruth<Rational>;

double toDouble(const Rational& x) { return boost::rational_cast<double>(x); }

Area hostileArea(Random& random, HostilePoints& points)
{
    return hostileRegion(random, points, 1).steps[0].area;
}

Area scaled(Area area, int x, int y)
{
    for (glm::dvec2& p : area.points)
        p = {std::ldexp(p.x, x), std::ldexp(p.y, y)};
    return area;
}
Region scaled(Region region, int x, int y)
{
    for (auto& step : region.steps)
        step.area = scaled(step.area, x, y);
    return region;
}

/// Whether two results are the same but for the scale.
bool areAlike(const ClippedArea& p, const ClippedArea& q, int x, int y)
{
    const auto sameOrigin = [](const EdgeOrigin& a, const EdgeOrigin& b) {
        return a.number == b.number && a.isOfWindow == b.isOfWindow;
    };
    return p.part == q.part && p.ringEnds == q.ringEnds
           && scaled(Area{p.points}, x, y).points == q.points
           && std::ranges::equal(p.origins, q.origins, sameOrigin);
}

} // namespace

class HostileTest : public QObject {
    Q_OBJECT

private slots:
    void nearlyCollinear()
    {
        Random random(1);
        const Region everything;
        int cut = 0;
        for (int i = 0; i < 150; ++i) {
            HostilePoints points(random, true);
            const Region area{{{hostileArea(random, points)}}, Keep::Inside};
            const Region window = hostileRegion(random, points, 2);
            const PreparedRegion prepared(area), at(window);
            const ClippedArea result = clipArea(prepared, at);
            QVERIFY(areTheSame(clipArea(inTree(area), inTree(window)), result));
            const std::string input = exactly({}, area) + "; " + exactly({}, window);
            const double exact = Truth(area, window).area<double>(toDouble);
            const double left = result.part == AreaPart::Whole
                                    ? Truth(area, everything).area<double>(toDouble)
                                    : toDouble(exactArea(result));
            QVERIFY2(std::abs(left - exact) < 1e-12, input.c_str());
            const auto fault = originFault(result, prepared, at, 16);
            QVERIFY2(fault.empty(), (fault + " for" + input).c_str());
            cut += result.part == AreaPart::Cut;
        }
        QVERIFY(cut > 50);
    }

    void anySizeIsClosed() // and ends
    {
        Random random(2);
        for (int i = 0; i < 1'000; ++i) {
            HostilePoints points(random, false);
            const PreparedRegion area({{{hostileArea(random, points)}}, Keep::Inside});
            const PreparedRegion window(hostileRegion(random, points, 2));
            const ClippedArea result = clipArea(area, window);
            QVERIFY(result.part != AreaPart::Refused);
            forEdges(result, [&](std::size_t j, const auto& from, const auto& to) {
                const auto& [number, isOfWindow, begin, end] = result.origins[j];
                const auto s = (isOfWindow ? window : area).edge(number).segment;
                QVERIFY(begin >= 0 && begin <= 1 && end >= 0 && end <= 1);
                const auto lies = [](double x, double a, double b) {
                    return x >= std::min(a, b) && x <= std::max(a, b);
                };
                for (const auto& p : {from, to})
                    QVERIFY(lies(p.x, s.a.x, s.b.x) && lies(p.y, s.a.y, s.b.y));
            });
        }
    }

    // Nothing but the exponents may differ: all decisions and roundings are exact.
    void scalingAnAxisChangesNothing()
    {
        Random random(3);
        for (int i = 0; i < 2'000; ++i) {
            HostilePoints points(random, true);
            const Area area = hostileArea(random, points);
            const Region window = hostileRegion(random, points, 2);
            const int x = random.whole(-700, 700), y = random.whole(-700, 700);
            const auto plain = clipArea(area, PreparedRegion(window));
            const auto other = clipArea(scaled(area, x, y), PreparedRegion(scaled(window, x, y)));
            VERIFY_OR_SAY(areAlike(plain, other, x, y),
                          (exactly({}, {{{area}}, Keep::Inside}) + exactly({}, window)).c_str());
        }
    }

    void whatIsNotFiniteIsRefused()
    {
        const Area square = areaOf({{0, 0}, {4, 4}});
        for (const double bad : {INFINITY, -INFINITY, NAN}) {
            const Area wrong{{{0, 0}, {1, 0}, {1, bad}}};
            const auto refused = [](const ClippedArea& result) {
                return result.part == AreaPart::Refused && result.points.empty();
            };
            const Region both{{{square}, {wrong}}, Keep::Inside};
            QVERIFY(refused(clipArea(wrong, PreparedRegion({{{square}}, Keep::Inside}))));
            QVERIFY(refused(clipArea(square, PreparedRegion(both))));
            QVERIFY(refused(clipArea(PreparedRegion(both), PreparedRegion(both))));
        }
    }
    void whatReachesToInfinityIsRefused()
    {
        const PreparedRegion hole({{{areaOf({{0, 0}, {4, 4}})}}, Keep::Outside});
        QCOMPARE(clipArea(hole, hole).part, AreaPart::Refused);
        QCOMPARE(clipArea(PreparedRegion(Region{}), hole).part, AreaPart::Refused);
        QCOMPARE(clipArea(areaOf({{0, 0}, {4, 4}}), hole).part, AreaPart::None);
    }

    /// Long edges beside each other: the tree takes over from the grid.
    void manyTeeth()
    {
        constexpr int teeth = 5'000;
        Area area;
        for (int i = 0; i < teeth; ++i)
            for (const int corner : {0, 1, 3, 2}) {
                const double along = (i + corner / 2 * 0.5) / teeth - 0.5, across = corner % 2;
                area.points.push_back({along + 0.1 * across, across - 0.1 * along});
            }
        const Area window = areaOf({{-0.2, 0.3}, {0.25, 0.6}});
        const Region filled{{{area}}, Keep::Inside};
        const auto inside = clipArea(area, PreparedRegion({{{window}}, Keep::Inside}));
        const auto outside = clipArea(area, PreparedRegion({{{window}}, Keep::Outside}));
        QVERIFY(inside.ringEnds.size() > 2'000 && outside.ringEnds.size() > 2'000);
        const ClippedArea clockwise{AreaPart::Cut, area.points, {4 * teeth}};
        const Rational sum = exactArea(inside) + exactArea(outside);
        QVERIFY(std::abs(toDouble(sum + exactArea(clockwise))) < 1e-12);
        const PreparedRegion same = inTree(filled);
        QVERIFY(areTheSame(clipArea(same, inTree({{{window}}, Keep::Inside})), inside));
    }

    void aHundredThousandEdges()
    {
        Area area, window;
        Random random(4);
        for (int i = 0; i < 100'000; ++i) {
            const double angle = 2e-5 * M_PI * i, r = random.between(90, 100);
            area.points.push_back({r * std::cos(angle), r * std::sin(angle)});
            window.points.push_back({5 + r * std::cos(angle), r * std::sin(angle)});
        }
        const auto inside = clipArea(area, PreparedRegion({{{window}}, Keep::Inside}));
        const auto outside = clipArea(area, PreparedRegion({{{window}}, Keep::Outside}));
        QVERIFY(inside.ringEnds.size() > 100 && outside.ringEnds.size() > 1'000);
        ClippedArea whole{AreaPart::Cut, area.points, {100'000}};
        const Rational sum = exactArea(inside) + exactArea(outside);
        QVERIFY(std::abs(toDouble(sum - exactArea(whole))) < 1e-8);
    }
};

} // namespace area_hostile_test

TEST_CLASS(area_hostile_test::HostileTest, Core)
#include "tests/clipping/area/hostile_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of clipping/area/clip_area.h on small grids, where nearly all is degenerate, against
// exact areas and exact winding numbers.
#include <QTest>

#include "tests/clipping/area/contract.h"
#include "tests/clipping/area/shapes.h"
#include "tests/clipping/area/truth.h"
#include "tests/clipping/region/contract.h"
#include "tests/clipping/region/in_tree.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace area_random_test {

using namespace clipping;
using namespace area_contract;

namespace {

using Truth = AreaTruth<region_oracle::SmallFraction>;

constexpr double gridStep = 0x1p-20; ///< of the points that are asked about: exact in double

Rational areaIn(const Truth& truth)
{
    return truth.area<Rational>(
        [](const auto& f) { return Rational(f.numerator(), f.denominator()); });
}

/// A point anywhere, or near to a corner of the result.
glm::dvec2 pointNear(Random& random, const ClippedArea& result, int size)
{
    glm::dvec2 p(random.between(-1, size + 1), random.between(-1, size + 1));
    if (random.whole(0, 1) && !result.points.empty()) {
        const auto last = static_cast<int>(result.points.size()) - 1;
        p = result.points[std::size_t(random.whole(0, last))]
            + glm::dvec2(random.between(-0.02, 0.02), random.between(-0.02, 0.02));
    }
    return {std::round(p.x / gridStep) * gridStep, std::round(p.y / gridStep) * gridStep};
}

std::string areaFault(const ClippedArea& result, const Truth& truth, const Truth& all)
{
    const Rational exact = areaIn(truth);
    if (result.part == AreaPart::Whole)
        return exact == areaIn(all) ? "" : "not whole";
    if ((result.part == AreaPart::None) != (exact == Rational(0)))
        return "wrong part";
    // All corners are off by at most half an ulp of 16, and there are fewer than 100.
    return abs(exactArea(result) - exact) < rational(0x1p-42) ? "" : "wrong area";
}

std::string windingFault(const ClippedArea& result, const Truth& truth, Random& random, int size)
{
    int sure = 0;
    for (int i = 0; i < 1'000; ++i) {
        const glm::dvec2 p = pointNear(random, result, size);
        const auto winding = windingAt(result, p, 1e-10);
        if (winding && *winding != int(truth.keeps<double>({p.x, p.y})))
            return "winding number " + std::to_string(*winding);
        sure += winding.has_value();
    }
    return sure > 700 ? "" : "too few points off the edges";
}

} // namespace

class RandomTest : public QObject {
    Q_OBJECT

private slots:
    void tenThousand()
    {
        Random random(1);
        std::array<int, 4> parts{};
        for (int i = 0; i < 10'000; ++i) {
            const int size = random.whole(2, 8);
            const Region area{{{gridArea(random, size, 7)}}, Keep::Inside}, everything;
            const Region window = gridWindow(random, size);
            const Truth truth(area, window), all(area, everything);
            const PreparedRegion prepared(area), at(window);
            const ClippedArea result = clipArea(prepared, at);
            ++parts[std::size_t(result.part)];
            std::string fault = areaFault(result, truth, all);
            if (fault.empty() && result.part != AreaPart::Whole)
                fault = windingFault(result, truth, random, size);
            if (fault.empty())
                fault = originFault(result, prepared, at, 16);
            if (fault.empty() && visitsTwice(result))
                fault = "a ring visits a corner twice";
            if (fault.empty() && !areTheSame(clipArea(inTree(area), inTree(window)), result))
                fault = "another result by the tree";
            VERIFY_OR_SAY(
                fault.empty(),
                (fault + " for" + exactly({}, area) + "; " + exactly({}, window)).c_str());
        }
        QVERIFY(parts[0] > 1'000 && parts[1] > 1'000 && parts[2] > 5'000 && parts[3] == 0);
    }

    /// Long edges, which are listed in many cells of the grid, but must meet each other once.
    void manyLongEdges()
    {
        Random random(3);
        for (int i = 0; i < 10; ++i) {
            Area area{{}, {}, random.whole(0, 1) ? FillRule::NonZero : FillRule::EvenOdd};
            for (int side = 0; side < 40; ++side)
                area.points.push_back({random.whole(0, 2) + side % 2 * 10, random.whole(0, 12)});
            const Region filled{{{area}}, Keep::Inside};
            const Region window{{{areaOf(Window{{3, 2}, {9, 11}})}}, Keep(random.whole(0, 1))};
            const Truth truth(filled, window);
            const ClippedArea result = clipArea(area, PreparedRegion(window));
            QVERIFY(result.part == AreaPart::Cut);
            QVERIFY(areTheSame(clipArea(inTree(filled), inTree(window)), result));
            // All corners are off by at most half an ulp of 16, and there are fewer than 4,000.
            const Rational off = exactArea(result) - areaIn(truth);
            VERIFY_OR_SAY(abs(off) < rational(0x1p-36), exactly({}, filled).c_str());
        }
    }

    void insideAndOutsideAreAll()
    {
        Random random(2);
        for (int i = 0; i < 2'000; ++i) {
            const Area area = gridArea(random, 8, 12);
            Region window = gridWindow(random, 8);
            const Region alone{{{area}}, Keep::Inside};
            const Truth all(alone, everything_); // which refer to them
            Rational sum(0);
            for (const Keep keep : {Keep::Inside, Keep::Outside}) {
                window.keep = keep;
                const ClippedArea result = clipArea(area, PreparedRegion(window));
                sum += result.part == AreaPart::Whole ? areaIn(all) : exactArea(result);
            }
            VERIFY_OR_SAY(abs(sum - areaIn(all)) < rational(0x1p-41), exactly({}, window).c_str());
        }
    }

private:
    const Region everything_;
};

} // namespace area_random_test

TEST_CLASS(area_random_test::RandomTest, Core)
#include "tests/clipping/area/random_test.moc"

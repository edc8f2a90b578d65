// SPDX-License-Identifier: GPL-3.0-or-later
// What clipping/area/clip_area.h does with areas that one can draw.
#include <QTest>

#include <chrono>
#include <stop_token>
#include <thread>

#include "tests/clipping/area/contract.h"
#include "tests/clipping/random.h"
#include "tests/test_class.h"

namespace area_clip_area_test {

using namespace clipping;
using namespace area_contract;

namespace {

PreparedRegion inside(const Area& area) { return PreparedRegion({{{area}}, Keep::Inside}); }
PreparedRegion outside(const Area& area) { return PreparedRegion({{{area}}, Keep::Outside}); }

Area rectangle(double x0, double y0, double x1, double y1) { return areaOf({{x0, y0}, {x1, y1}}); }

double areaOf(const ClippedArea& result) { return boost::rational_cast<double>(exactArea(result)); }

/// Its rings, each from its lowest leftmost corner, in order.
std::vector<std::vector<glm::dvec2>> ringsOf(const ClippedArea& result)
{
    const auto before = [](const glm::dvec2& p, const glm::dvec2& q) {
        return p.x != q.x ? p.x < q.x : p.y < q.y;
    };
    std::vector<std::vector<glm::dvec2>> rings;
    std::size_t begin = 0;
    for (const std::size_t end : result.ringEnds) {
        std::vector ring(result.points.begin() + std::ptrdiff_t(begin),
                         result.points.begin() + std::ptrdiff_t(end));
        std::ranges::rotate(ring, std::ranges::min_element(ring, before));
        rings.push_back(std::move(ring));
        begin = end;
    }
    std::ranges::sort(rings, [&](const auto& p, const auto& q) { return before(p[0], q[0]); });
    return rings;
}

using Rings = std::vector<std::vector<glm::dvec2>>;

} // namespace

class ClipAreaTest : public QObject {
    Q_OBJECT

private slots:
    void aCornerOfASquare()
    {
        const auto result = clipArea(rectangle(0, 0, 4, 4), inside(rectangle(3, 2, 9, 9)));
        QCOMPARE(result.part, AreaPart::Cut);
        QCOMPARE(ringsOf(result), (Rings{{{3, 2}, {4, 2}, {4, 4}, {3, 4}}}));
    }
    void originsTellTheCutFromTheEdge()
    {
        const auto result = clipArea(rectangle(0, 0, 4, 4), inside(rectangle(3, 2, 9, 9)));
        QCOMPARE(result.origins.size(), 4u);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& [number, isOfWindow, from, to] = result.origins[i];
            const glm::dvec2& p = result.points[i];
            if (p == glm::dvec2(4, 2))
                QVERIFY(!isOfWindow && number == 2 && from == 0.5 && to == 1);
            else if (p == glm::dvec2(4, 4))
                QVERIFY(!isOfWindow && number == 3 && from == 0 && to == 0.25);
            else
                QVERIFY(isOfWindow && number == (p == glm::dvec2(3, 2) ? 1u : 4u));
        }
    }
    void aClockwiseAreaIsReversed()
    {
        const Area square{{{0, 0}, {0, 4}, {4, 4}, {4, 0}}};
        const auto result = clipArea(square, inside(rectangle(-1, -1, 2, 5)));
        QCOMPARE(ringsOf(result), (Rings{{{0, 0}, {2, 0}, {2, 4}, {0, 4}}}));
        const auto left = std::ranges::find(result.origins, 1u, &EdgeOrigin::number);
        QVERIFY(left != result.origins.end() && left->from == 1 && left->to == 0);
    }

    // A comb cut across its teeth falls apart, without bridges between them.
    void aConcaveAreaFallsApart()
    {
        const Area comb{{{0, 0}, {10, 0}, {10, 9}, {8, 9}, {8, 2}, {2, 2}, {2, 9}, {0, 9}}};
        const auto result = clipArea(comb, inside(rectangle(-1, 5, 11, 20)));
        QCOMPARE(ringsOf(result),
                 (Rings{{{0, 5}, {2, 5}, {2, 9}, {0, 9}}, {{8, 5}, {10, 5}, {10, 9}, {8, 9}}}));
    }
    void aHoleIsClockwise()
    {
        const auto result = clipArea(rectangle(0, 0, 9, 9), outside(rectangle(2, 2, 5, 5)));
        QCOMPARE(ringsOf(result),
                 (Rings{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{2, 2}, {2, 5}, {5, 5}, {5, 2}}}));
        QCOMPARE(areaOf(result), 72.0);
    }
    void aWindowInTheMiddle()
    {
        const auto result = clipArea(rectangle(0, 0, 9, 9), inside(rectangle(2, 2, 5, 5)));
        QCOMPARE(ringsOf(result), (Rings{{{2, 2}, {5, 2}, {5, 5}, {2, 5}}}));
        QVERIFY(std::ranges::all_of(result.origins, &EdgeOrigin::isOfWindow));
    }

    void nothingAndEverything()
    {
        const Area square = rectangle(0, 0, 4, 4);
        QCOMPARE(clipArea(square, inside(rectangle(5, 0, 9, 9))).part, AreaPart::None);
        QCOMPARE(clipArea(square, outside(rectangle(5, 0, 9, 9))).part, AreaPart::Whole);
        QCOMPARE(clipArea(square, inside(rectangle(-1, -1, 9, 9))).part, AreaPart::Whole);
        QCOMPARE(clipArea(square, outside(rectangle(-1, -1, 9, 9))).part, AreaPart::None);
        QCOMPARE(clipArea(square, PreparedRegion(Region{})).part, AreaPart::Whole);
        QCOMPARE(clipArea(Area{}, inside(square)).part, AreaPart::None);
    }
    // The window's edge runs along the area's, from within, from without.
    void touchingAlongAnEdge()
    {
        const Area square = rectangle(0, 0, 4, 4);
        QCOMPARE(clipArea(square, inside(rectangle(0, 0, 9, 9))).part, AreaPart::Whole);
        QCOMPARE(clipArea(square, inside(square)).part, AreaPart::Whole);
        QCOMPARE(clipArea(square, outside(square)).part, AreaPart::None);
        QCOMPARE(clipArea(square, inside(rectangle(4, 1, 9, 3))).part, AreaPart::None);
        QCOMPARE(clipArea(square, outside(rectangle(4, 1, 9, 3))).part, AreaPart::Whole);
        const auto half = clipArea(square, inside(rectangle(2, 0, 4, 4)));
        QCOMPARE(ringsOf(half), (Rings{{{2, 0}, {4, 0}, {4, 4}, {2, 4}}}));
        // Where both have an edge, it is the area's: its stroke stays.
        QCOMPARE(std::ranges::count_if(half.origins, &EdgeOrigin::isOfWindow), 1);
    }
    void ringsThatTouchInACorner()
    {
        const Area both{{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {2, 2}, {4, 2}, {4, 4}, {2, 4}}, {4, 8}};
        const auto result = clipArea(both, inside(rectangle(-1, 1, 9, 9)));
        QCOMPARE(ringsOf(result),
                 (Rings{{{0, 1}, {2, 1}, {2, 2}, {0, 2}}, {{2, 2}, {4, 2}, {4, 4}, {2, 4}}}));
    }

    void aStarKeepsItsRule()
    {
        Area star{{{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}}};
        const PreparedRegion window = inside(rectangle(-20, -20, 20, 4));
        const auto full = clipArea(star, window);
        star.rule = FillRule::EvenOdd;
        const auto hollow = clipArea(star, window);
        QCOMPARE(full.ringEnds.size(), 1u);
        QCOMPARE(hollow.ringEnds.size(), 5u);        // four tips and the cut one
        QVERIFY(areaOf(full) > areaOf(hollow) + 30); // the middle, cut above
        QVERIFY(std::ranges::all_of(std::array{full, hollow}, [](const ClippedArea& result) {
            return windingAt(result, {0, 3.5}, 1e-9) == 1; // inside the tip
        }));
        QCOMPARE(windingAt(full, {0, 0}, 1e-9), std::optional(1));
        QCOMPARE(windingAt(hollow, {0, 0}, 1e-9), std::optional(0));
    }
    void severalWindowsTogether()
    {
        const Region window{{{rectangle(0, 0, 4, 9)},
                             {rectangle(4, 0, 8, 9)}, // shares an edge, which leaves no trace
                             {rectangle(3, 3, 5, 6), AreaOperation::CutOut}},
                            Keep::Inside};
        const auto result = clipArea(rectangle(-1, 1, 9, 8), PreparedRegion(window));
        QCOMPARE(areaOf(result), 8.0 * 7 - 6);
        QCOMPARE(result.ringEnds.size(), 2u);
        QCOMPARE(result.points.size(), 8u);
    }
    void aRegionOfSeveralAreasIsClipped()
    {
        const PreparedRegion two(
            {{{rectangle(0, 0, 4, 4)}, {rectangle(2, 0, 6, 4)}}, Keep::Inside});
        const auto result = clipArea(two, inside(rectangle(1, 1, 9, 9)));
        QCOMPARE(ringsOf(result), (Rings{{{1, 1}, {6, 1}, {6, 4}, {4, 4}, {1, 4}}}));
        QVERIFY(result.part == AreaPart::Cut && areaOf(result) == 15);
    }
    // Whenever the stop is requested, nothing is known, or the result is complete.
    void aStopEndsIt()
    {
        Random random(4);
        Area area, window;
        for (int i = 0; i < 400; ++i)
            for (Area* each : {&area, &window})
                each->points.push_back({random.between(0, 100), random.between(0, 100)});
        area.rule = FillRule::EvenOdd;
        const PreparedRegion at = inside(window);
        const ClippedArea whole = clipArea(area, at);
        QVERIFY(whole.part == AreaPart::Cut);
        std::stop_source before;
        before.request_stop();
        QVERIFY(clipArea(area, at, before.get_token()).part == AreaPart::Stopped);
        bool isStopped = true;
        for (int wait = 1; isStopped; wait = 2 * wait + 1) {
            std::stop_source stop;
            const std::jthread later([&] {
                std::this_thread::sleep_for(std::chrono::milliseconds(wait));
                stop.request_stop();
            });
            const ClippedArea result = clipArea(area, at, stop.get_token());
            isStopped = result.part == AreaPart::Stopped;
            QVERIFY(isStopped ? result.points.empty() : result.points == whole.points);
        }
    }
};

} // namespace area_clip_area_test

TEST_CLASS(area_clip_area_test::ClipAreaTest, Core)
#include "tests/clipping/area/clip_area_test.moc"

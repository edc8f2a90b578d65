// SPDX-License-Identifier: GPL-3.0-or-later
// Turned windows (clipping/turned_window.h) with every row, against rational numbers: the window is
// the exact rectangle of its definition, with the cosine and sine that the library uses.
#include "clipping/turned_window.h"

#include <QTest>

#include <algorithm>
#include <cmath>

#include "tests/clipping/rows.h"
#include "tests/clipping/same_bits.h"
#include "tests/clipping/scenes.h"
#include "tests/clipping/turned_contract.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace turned_window_test {

using namespace clipping;

using turned_contract::described;
using turned_contract::Frame;
using turned_contract::turnedFault;
using turned_contract::ulpOf;

namespace {

Segment someSegment(RandomNumbers& random, const TurnedWindow& w, double size)
{
    const auto anywhere = [&] {
        const double x = random.uniform(-3, 3);
        return size * glm::dvec2(x, random.uniform(-3, 3));
    };
    const auto corners = cornersOf(w).corners;
    const auto corner = corners[std::size_t(random.integer(0, 3))];
    const auto other = corners[std::size_t(random.integer(0, 3))];
    switch (random.integer(0, 4)) {
    case 0:
        return {corner, anywhere()};
    case 1:
        return {2.0 * corner - other, 2.0 * other - corner}; // along an edge, or a diagonal
    case 2: {
        const auto way = anywhere();
        return {corner - way, corner + way};
    }
    default:
        return {anywhere(), anywhere()};
    }
}

TurnedWindow someWindow(RandomNumbers& random, double size)
{
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const double width = random.integer(0, 9) == 0 ? 0 : random.uniform(0, 2);
    const double degrees =
        random.integer(0, 3) == 0 ? 45.0 * random.integer(-9, 9) : random.uniform(-400, 400);
    return {size * glm::dvec2(x, y), size * glm::dvec2(width, random.uniform(0, 2)), degrees};
}

} // namespace

class TurnedWindowTest : public QObject {
    Q_OBJECT

private slots:
    void everyRowKeepsTheBound_data() { everyAlgorithm(); }
    void everyRowKeepsTheBound()
    {
        QFETCH(const Algorithm*, algorithm);
        RandomNumbers random(31);
        for (int i = 0; i < 2'000; ++i) {
            const double size =
                std::array{1.0, 100.0, 0x1p-1070, 0x1p1021, 1e-9}[std::size_t(i % 5)];
            const auto w = someWindow(random, i % 5 == 3 ? size / 4 : size);
            const Segment s = someSegment(random, w, i % 5 == 3 ? size / 4 : size);
            const auto wrong = turnedFault(*algorithm, s, w);
            VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + described(s, w)).c_str());
        }
    }

    void aQuarterTurnIsExact_data() { everyAlgorithm(); }
    void aQuarterTurnIsExact()
    {
        QFETCH(const Algorithm*, algorithm);
        const Window axisAligned{{-2, -3}, {2, 3}};
        const auto wholeNumbers = hardScenes<double>(500)[1].segments;
        for (const auto& s : wholeNumbers)
            for (const int quarters : {-5, 0, 1, 2, 3, 4}) {
                const bool lies = quarters % 2 != 0;
                const auto found =
                    clipTurned(algorithm->corrected, s, {{}, {2, 3}, 90.0 * quarters});
                const auto expected =
                    algorithm->corrected.clip(s, lies ? Window{{-3, -2}, {3, 2}} : axisAligned);
                QCOMPARE(found.has_value(), expected.has_value());
                if (found)
                    QVERIFY(std::abs(found->a.x - expected->a.x) < 1e-13
                            && std::abs(found->a.y - expected->a.y) < 1e-13);
            }
    }

    // A new end is within K ulps of the segment and of the window's edge. Where these meet at an
    // angle whose sine is at least 1/8, the second cut is within 8 * 2K of the first along the
    // segment, and K ulps off it: 17 K on each axis.
    void cuttingTwiceChangesNextToNothing_data() { everyAlgorithm(); }
    void cuttingTwiceChangesNextToNothing()
    {
        QFETCH(const Algorithm*, algorithm);
        RandomNumbers random(33);
        const TurnedWindow w{{10, -20}, {150, 90}, 30};
        const auto across = [&](const Segment& s) { // the sines at both pairs of edges
            const Segment turnedBack =
                traceTurned(algorithm->corrected, s, {w.centre, {1e6, 1e6}, 30}).visible;
            const glm::dvec2 d = turnedBack.b - turnedBack.a;
            return std::min(std::abs(d.x), std::abs(d.y)) / std::hypot(d.x, d.y);
        };
        int seen = 0;
        for (int i = 0; i < 2'000; ++i) {
            const Segment s = someSegment(random, w, 150);
            const auto once = clipTurned(algorithm->corrected, s, w);
            if (!once || once->a == once->b || across(s) < 0.125)
                continue;
            const double most = 17 * turnedUlps(*algorithm) * ulpOf(s, w);
            if (std::hypot(once->b.x - once->a.x, once->b.y - once->a.y) < 4 * most)
                continue; // as good as a contact
            const auto again = clipTurned(algorithm->corrected, *once, w);
            VERIFY_OR_SAY(again.has_value(), described(s, w).c_str());
            for (const glm::dvec2& d : {again->a - once->a, again->b - once->b})
                VERIFY_OR_SAY(std::max(std::abs(d.x), std::abs(d.y)) <= most,
                              described(s, w).c_str());
            ++seen;
        }
        QVERIFY(seen > 300);
    }

    void manyTraceAndCountAgreeWithOne_data() { everyAlgorithm(); }
    void manyTraceAndCountAgreeWithOne()
    {
        QFETCH(const Algorithm*, algorithm);
        RandomNumbers random(32);
        const TurnedWindow w{{1, 2}, {3, 1}, 30};
        std::vector<Segment> segments;
        for (int i = 0; i < 1'000; ++i)
            segments.push_back(someSegment(random, w, 3));
        segments.push_back({{-1.7e308, -1.7e308}, {1.7e308, 1.7e308}});
        segments.push_back({{NAN, 0}, {1, 1}});
        for (const auto* form : {&algorithm->corrected, algorithm->published}) {
            if (!form)
                continue;
            std::vector<Clipped> out(segments.size());
            out.resize(clipAllTurned(*form, segments, w, out));
            auto next = out.begin();
            for (std::size_t i = 0; i < segments.size(); ++i) {
                const auto piece = clipTurned(*form, segments[i], w);
                const bool seen = next != out.end() && next->source == i;
                QCOMPARE(seen, piece.has_value());
                const Trace trace = traceTurned(*form, segments[i], w);
                QCOMPARE(trace.outcome == Outcome::Visible, seen);
                if (!seen)
                    continue;
                if (form == &algorithm->corrected) {
                    QVERIFY(sameBits(*piece, next->segment));
                    QVERIFY(std::abs(trace.visible.a.x) <= 3 && std::abs(trace.visible.a.y) <= 1);
                    QVERIFY(cutEdgeOfA(next->cut) != Edge::NoEdge
                            || next->segment.a == segments[i].a);
                }
                ++next;
            }
            QVERIFY(countTurned(*form, segments, w).comparisons > 0);
        }
    }

    void contactsArePoints()
    {
        const auto& exact = exactAlgorithm();
        const TurnedWindow w{{0, 0}, {1, 1}, 90};
        const auto found = clipTurned(exact.corrected, {{0, 2}, {2, 0}}, w);
        QVERIFY(found && found->a == found->b && found->a == glm::dvec2(1, 1));
    }

    void cornersAreRounded()
    {
        const auto corners = cornersOf({{1, 2}, {4, 3}, 90}).corners;
        const std::vector<glm::dvec2> expected{{4, -2}, {4, 6}, {-2, 6}, {-2, -2}};
        QCOMPARE(corners, expected);
        QVERIFY(turned({{0, 2}, {4, 4}}, 7).centre == glm::dvec2(2, 3));
        RandomNumbers random(33);
        for (int i = 0; i < 2'000; ++i) {
            const auto w = someWindow(random, 10);
            const Frame frame(w);
            const Rational ulp = rational(ulpOf({w.centre, w.centre}, w));
            for (const auto& corner : cornersOf(w).corners) {
                const auto p = frame.into(corner);
                QVERIFY(abs(abs(p.x) - rational(w.half.x)) <= Rational(4) * ulp);
                QVERIFY(abs(abs(p.y) - rational(w.half.y)) <= Rational(4) * ulp);
            }
        }
    }

    void badNumbersGiveNothing()
    {
        const auto& form = exactAlgorithm().corrected;
        const Segment s{{-9, 0}, {9, 0}};
        QVERIFY(clipTurned(form, s, {{0, 0}, {1, 1}, 10}));
        for (const double bad : {double(NAN), double(INFINITY)})
            for (const TurnedWindow& w :
                 {TurnedWindow{{bad, 0}, {1, 1}, 10}, TurnedWindow{{0, 0}, {1, bad}, 10},
                  TurnedWindow{{0, 0}, {1, 1}, bad}})
                QVERIFY(!clipTurned(form, s, w));
        QVERIFY(!clipTurned(form, s, {{0, 0}, {-1, 1}, 10}));
        QVERIFY(!clipTurned(form, {{-9, 0}, {double(INFINITY), 0}}, {{0, 0}, {1, 1}, 10}));
    }
};

} // namespace turned_window_test

TEST_CLASS(turned_window_test::TurnedWindowTest, None)
#include "tests/clipping/turned_window_test.moc"

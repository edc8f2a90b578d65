// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of halving alone: how it stops, and where it puts a contact.
#include <cmath>

#include "tests/clipping/contract.h"
#include "tests/clipping/random.h"
#include "tests/clipping/rows.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace algorithms_midpoint_subdivision_test {

using namespace clipping;

namespace {

const Algorithm& midpointSubdivision() { return *findAlgorithm("midpoint-subdivision"); }

bool contains(const Window& w, const glm::dvec2& p)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

} // namespace

class MidpointSubdivisionTest : public QObject {
    Q_OBJECT

private slots:
    // The middle of two neighbours is the even one: at an edge whose last bit is odd, the outer
    // one.
    void publishedEndsAtEdgesWithAnOddLastBit()
    {
        const Window odd{{-0.3, -0.3}, {0.3, 0.3}};
        for (int i = 0; i < 100; ++i) {
            const glm::dvec2 way{std::cos(0.1 + i), std::sin(0.1 + i)};
            const auto trace = midpointSubdivision().published->trace({-3.0 * way, 4.0 * way}, odd);
            QCOMPARE(trace.outcome, Outcome::Visible);
        }
    }

    // Past a corner the last two points may be neighbours that are outside for different reasons:
    // nothing is left to halve, and the point found is not visible.
    void publishedRejectsASegmentPastACorner()
    {
        Random random(1);
        int neighbours = 0;
        for (int i = 0; i < 10'000; ++i) {
            const glm::dvec2 corner(random.unit(), random.unit());
            const glm::dvec2 way(random.unit(), random.unit());
            const Input input{
                {corner - random.between(0, 3) * way, corner + random.between(0, 3) * way},
                {{corner.x, corner.y - 5}, {corner.x + 5, corner.y}}};
            const auto trace = midpointSubdivision().published->trace(input.segment, input.window);
            if (trace.outcome == Outcome::Visible)
                VERIFY_OR_SAY(contains(input.window, trace.visible.a)
                                  && contains(input.window, trace.visible.b),
                              exactly(input).c_str());
            neighbours +=
                trace.outcome == Outcome::Invisible && trace.steps.back().label == "rejectNear";
        }
        QVERIFY(neighbours > 100);
    }

    // A contact has the coordinates of both sides between which it was found, not those of the
    // multiple of 2^-53 of the segment that is next to it.
    void correctedPutsAContactOnTheCorner()
    {
        Random random(1);
        int contacts = 0;
        for (int i = 0; i < 50'000; ++i) {
            const glm::dvec2 corner(random.unit(), random.unit());
            const glm::dvec2 way(random.between(1, 100), random.between(1, 100));
            const Input input{
                {corner - random.between(0, 9) * way, corner + random.between(0, 9) * way},
                {{corner.x, corner.y - 5}, {corner.x + 5, corner.y}}};
            const auto result = midpointSubdivision().corrected.clip(input.segment, input.window);
            if (!result || result->a != result->b)
                continue;
            ++contacts;
            VERIFY_OR_SAY(result->a == corner, exactly(input).c_str());
        }
        QVERIFY(contacts > 1'000);
    }

    // If only one end is visible, it is returned unchanged: not as End 1 plus the whole way from
    // there, which rounding may take elsewhere.
    void correctedKeepsAnEndThatTouches()
    {
        Random random(1);
        for (int i = 0; i < 10'000; ++i) {
            const Window w{{random.unit(), 0}, {2, 1}};
            const Segment s{{w.min.x - random.between(1e-3, 9), random.between(-3, 3)},
                            {w.min.x, random.unit()}};
            const auto result = midpointSubdivision().corrected.clip(s, w);
            VERIFY_OR_SAY(result && sameBits(*result, Segment{s.b, s.b}),
                          exactly(Input{s, w}).c_str());
        }
    }
};

} // namespace algorithms_midpoint_subdivision_test

TEST_CLASS(algorithms_midpoint_subdivision_test::MidpointSubdivisionTest, None)
#include "tests/clipping/algorithms/midpoint_subdivision_test.moc"

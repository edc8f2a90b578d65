// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and rays keep the contract of clipping/algorithm.h: for every row that clips them, against
// whole numbers of any length. The inputs are those of the segments, whose two points are all the
// same numbers.
#include <limits>

#include "tests/clipping/line_or_ray_contract.h"
#include "tests/clipping/rows.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace lines_and_rays_test {

using namespace clipping;

namespace {

/// The functions of a row for lines or for rays.
template <class S>
struct Row {
    const Algorithm* algorithm;
    const Functions<S, Window, Segment>* uses;
    static constexpr bool isRay = std::is_same_v<S, Ray>;

    std::string faultAt(const Input& input, double k) const
    {
        const auto found = uses->clip(S{input.segment.a, input.segment.b}, input.window);
        const auto wrong = lineOrRayFault(found, input, isRay, k);
        return wrong.empty() ? "" : wrong + " for " + exactly(input);
    }
};

template <class S>
std::vector<Row<S>> rows()
{
    std::vector<Row<S>> all;
    for (const Algorithm& a : algorithms()) {
        if constexpr (std::is_same_v<S, Line>)
            all.push_back({&a, a.line});
        else
            all.push_back({&a, a.ray});
        if (!all.back().uses)
            all.pop_back();
    }
    return all;
}

template <class S>
void compareFamilies()
{
    for (const Family& family : families()) {
        const auto& inputs = family.inputs();
        const std::size_t step = std::max<std::size_t>(1, inputs.size() / 15'000);
        for (std::size_t i = 0; i < inputs.size(); i += step)
            for (const auto& row : rows<S>()) {
                const auto wrong = row.faultAt(inputs[i], row.algorithm->ulps);
                QVERIFY2(wrong.empty(), (row.algorithm->key.data() + (": " + wrong)).c_str());
            }
    }
}

/// On small whole numbers every decision must be right.
template <class S>
void compareGrid()
{
    for (const Input& input : grid())
        for (const auto& row : rows<S>()) {
            const auto wrong = row.faultAt(input, 0);
            QVERIFY2(wrong.empty(), (row.algorithm->key.data() + (": " + wrong)).c_str());
        }
}

template <class S>
void compareUses()
{
    for (const Family& family : families()) {
        const auto& inputs = family.inputs();
        for (std::size_t i = 0; i < inputs.size() && i < 2'000; ++i)
            for (const auto& [algorithm, uses] : rows<S>()) {
                const auto& [points, w] = inputs[i];
                const S lineOrRay{points.a, points.b};
                const auto text = [&] { return exactly(inputs[i]); };
                const auto piece = uses->clip(lineOrRay, w);
                std::array<Clipped, 1> out;
                VERIFY_OR_SAY((uses->clipAll({&lineOrRay, 1}, w, out) == 1) == piece.has_value(),
                              text().c_str());
                const Trace trace = uses->trace(lineOrRay, w);
                VERIFY_OR_SAY((trace.outcome == Outcome::Visible) == piece.has_value(),
                              text().c_str());
                VERIFY_OR_SAY(trace.steps.empty() == (points.a == points.b), text().c_str());
                const auto cost = uses->count({&lineOrRay, 1}, w);
                VERIFY_OR_SAY((cost.comparisons == 0) == (points.a == points.b), text().c_str());
                if (!piece)
                    continue;
                VERIFY_OR_SAY(sameBits(*piece, out[0].segment) && sameBits(*piece, trace.visible),
                              text().c_str());
                const bool keepsA = Row<S>::isRay && piece->a == points.a;
                VERIFY_OR_SAY((cutEdgeOfA(out[0].cut) == Edge::NoEdge) == keepsA, text().c_str());
                VERIFY_OR_SAY(cutEdgeOfB(out[0].cut) != Edge::NoEdge, text().c_str());
            }
    }
}

template <class S>
void compareWithoutNumbers()
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const auto& [algorithm, uses] : rows<S>()) {
        for (const double by : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
            for (int index = 0; index < 8; ++index) {
                S lineOrRay{{-1, 0.5}, {3, 0.5}};
                Window w{{0, 0}, {2, 2}};
                QVERIFY(uses->clip(lineOrRay, w));
                *std::array{
                    &lineOrRay.a.x, &lineOrRay.a.y, &lineOrRay.b.x, &lineOrRay.b.y,
                    &w.min.x,       &w.min.y,       &w.max.x,       &w.max.y}[std::size_t(index)] =
                    by;
                QVERIFY(!uses->clip(lineOrRay, w));
                QVERIFY(uses->trace(lineOrRay, w).steps.empty());
            }
        QVERIFY(!uses->clip(S{{-1, 0.5}, {3, 0.5}}, {{2, 0}, {0, 2}}));
    }
}

} // namespace

class LinesAndRaysTest : public QObject {
    Q_OBJECT

private slots:
    void fourRowsHaveLinesAndRays()
    {
        for (const char* key : {"liang-barsky", "cyrus-beck", "skala", "matthes-drakopoulos"}) {
            QVERIFY2(findAlgorithm(key)->line, key);
            QVERIFY2(findAlgorithm(key)->ray, key);
        }
    }
    void linesOfTheGrid() { compareGrid<Line>(); }
    void raysOfTheGrid() { compareGrid<Ray>(); }
    void lines() { compareFamilies<Line>(); }
    void rays() { compareFamilies<Ray>(); }
    void clipAllTraceAndCountAgreeForLines() { compareUses<Line>(); }
    void clipAllTraceAndCountAgreeForRays() { compareUses<Ray>(); }
    void nonFiniteLinesGiveNothing() { compareWithoutNumbers<Line>(); }
    void nonFiniteRaysGiveNothing() { compareWithoutNumbers<Ray>(); }
};

} // namespace lines_and_rays_test

TEST_CLASS(lines_and_rays_test::LinesAndRaysTest, None)
#include "tests/clipping/lines_and_rays_test.moc"

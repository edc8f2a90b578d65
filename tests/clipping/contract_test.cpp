// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of clipping/algorithm.h, for every algorithm of the catalogue, against the oracle.
#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "tests/clipping/contract.h"
#include "tests/clipping/random.h"
#include "tests/clipping/rows.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace contract_test {

using namespace clipping;

namespace {

/// A family with its exact results; only the last one requested is stored.
struct Known {
    const Family* family = nullptr;
    std::vector<Input> inputs;
    std::vector<std::optional<oracle::Part>> truths;
};
const Known& known(const Family& family)
{
    static Known last;
    if (last.family != &family) {
        last = {&family, family.inputs(), {}};
        for (const Input& input : last.inputs)
            last.truths.push_back(truthOf(input));
    }
    return last;
}

/// The result of the row's float form for an input whose numbers are all floats.
std::optional<Segment> clippedInFloat(const Algorithm& algorithm, const Input& input)
{
    const auto& [s, w] = input;
    const auto piece = algorithm.floats->clip({glm::vec2(s.a), glm::vec2(s.b)},
                                              {glm::vec2(w.min), glm::vec2(w.max)});
    if (!piece)
        return std::nullopt;
    return Segment{glm::dvec2(piece->a), glm::dvec2(piece->b)};
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A segment through the window with one of the eight numbers replaced.
Input spoilt(int index, double by)
{
    Input input{{{-1, 0.5}, {3, 0.5}}, {{0, 0}, {2, 2}}};
    const std::array numbers{&input.segment.a.x,  &input.segment.a.y,  &input.segment.b.x,
                             &input.segment.b.y,  &input.window.min.x, &input.window.min.y,
                             &input.window.max.x, &input.window.max.y};
    *numbers[std::size_t(index)] = by;
    return input;
}

bool seesNothing(const Functions<Segment, Window>& uses, const Input& input)
{
    std::array<Clipped, 1> out;
    return !uses.clip(input.segment, input.window)
           && uses.clipAll({&input.segment, 1}, input.window, out) == 0
           && uses.trace(input.segment, input.window).outcome == Outcome::Invisible;
}

} // namespace

class ContractTest : public QObject {
    Q_OBJECT

private slots:
    void correctedFormsKeepTheContract_data()
    {
        QTest::addColumn<const Family*>("family");
        QTest::addColumn<const Algorithm*>("algorithm");
        for (const Family& f : families())
            for (const Algorithm& a : algorithms())
                QTest::addRow("%s %s", f.name, a.key.data()) << &f << &a;
    }
    void correctedFormsKeepTheContract()
    {
        QFETCH(const Family*, family);
        QFETCH(const Algorithm*, algorithm);
        const Known& all = known(*family);
        for (std::size_t i = 0; i < all.inputs.size(); ++i) {
            const Input& input = all.inputs[i];
            const auto result = algorithm->corrected.clip(input.segment, input.window);
            const auto wrong = fault(result, input, all.truths[i], algorithm->ulps);
            VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(input)).c_str());
        }
    }

    // The same bound in float, for data that is float.
    void floatFormsKeepTheContract_data()
    {
        QTest::addColumn<const Family*>("family");
        QTest::addColumn<const Algorithm*>("algorithm");
        for (const Family& f : singleFamilies())
            for (const Algorithm& a : algorithms())
                QTest::addRow("%s %s", f.name, a.key.data()) << &f << &a;
    }
    void floatFormsKeepTheContract()
    {
        QFETCH(const Family*, family);
        QFETCH(const Algorithm*, algorithm);
        const Known& all = known(*family);
        for (std::size_t i = 0; i < all.inputs.size(); ++i) {
            const Input& input = all.inputs[i];
            const auto result = clippedInFloat(*algorithm, input);
            const auto wrong =
                fault(result, input, all.truths[i], algorithm->ulps, oracle::Number::Single);
            VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(input)).c_str());
        }
    }

    void kIsAtMost64_data() { everyAlgorithm(); }
    void kIsAtMost64()
    {
        QFETCH(const Algorithm*, algorithm);
        QVERIFY(algorithm->ulps > 0 && algorithm->ulps <= 64);
    }

    // On small whole numbers nothing is near a limit of rounding: every decision must be right,
    // and a contact is a point.
    void visibilityIsRightOnTheGrid_data() { everyAlgorithm(); }
    void visibilityIsRightOnTheGrid()
    {
        QFETCH(const Algorithm*, algorithm);
        for (const Input& input : notEmpty(grid())) {
            const auto truth = truthOf(input);
            const auto result = algorithm->corrected.clip(input.segment, input.window);
            if (truth.has_value() != result.has_value())
                QFAIL(exactly(input).c_str());
            if (truth && truth->line.a.x == truth->line.b.x && truth->line.a.y == truth->line.b.y
                && result->a != result->b)
                QFAIL(exactly(input).c_str());
        }
    }

    // Lines that meet a window only at a corner, with whole numbers too large for the grid.
    void contactsAtCornersArePoints_data() { everyAlgorithm(); }
    void contactsAtCornersArePoints()
    {
        QFETCH(const Algorithm*, algorithm);
        Random random(1);
        for (int i = 0; i < 50'000; ++i) {
            const glm::dvec2 low(random.whole(-250, 230), random.whole(-250, 230));
            const Window w{low, low + glm::dvec2(random.whole(0, 20), random.whole(0, 20))};
            // Falling past the top right or bottom left corner, or rising past the other two.
            const bool falls = i % 2 == 0, high = i % 4 < 2;
            const glm::dvec2 corner(high ? w.max.x : w.min.x, high == falls ? w.max.y : w.min.y);
            const glm::dvec2 step(random.whole(1, 40), random.whole(1, 40) * (falls ? -1 : 1));
            const int most = int(250 / std::max(std::abs(step.x), std::abs(step.y)));
            Segment s{corner - double(random.whole(1, most)) * step,
                      corner + double(random.whole(1, most)) * step};
            if (i % 8 < 4)
                std::swap(s.a, s.b);
            const auto result = algorithm->corrected.clip(s, w);
            VERIFY_OR_SAY(result && result->a == result->b, exactly(Input{s, w}).c_str());
        }
    }

    void nonFiniteNumbersGiveNothing_data() { everyAlgorithm(); }
    void nonFiniteNumbersGiveNothing()
    {
        QFETCH(const Algorithm*, algorithm);
        for (int index = 0; index < 8; ++index)
            for (const double by : {none, infinite, -infinite}) {
                const Input input = spoilt(index, by);
                VERIFY_OR_SAY(seesNothing(algorithm->corrected, input), exactly(input).c_str());
            }
    }

    void invertedWindowsGiveNothing_data() { everyAlgorithm(); }
    void invertedWindowsGiveNothing()
    {
        QFETCH(const Algorithm*, algorithm);
        const Segment s{{-1, 0.5}, {3, 0.5}};
        QVERIFY(seesNothing(algorithm->corrected, {s, {{2, 0}, {0, 2}}}));
        QVERIFY(seesNothing(algorithm->corrected, {s, {{0, 2}, {2, 0}}}));
        QVERIFY(seesNothing(algorithm->corrected, {{{1, 1}, {1, 1}}, {{2, 2}, {0, 0}}}));
    }

    // The published form must return for every input.
    void publishedFormsAlwaysReturn_data() { everyAlgorithm(); }
    void publishedFormsAlwaysReturn()
    {
        QFETCH(const Algorithm*, algorithm);
        if (!algorithm->published)
            QSKIP("this row has no published form");
        const auto run = [&](const Input& input) {
            algorithm->published->clip(input.segment, input.window);
        };
        const auto trace = [&](const Input& input) {
            algorithm->published->trace(input.segment, input.window);
        };
        for (int index = 0; index < 8; ++index)
            for (const double by : {none, infinite, -infinite})
                run(spoilt(index, by)), trace(spoilt(index, by));
        for (const Family& family : families())
            if (family.name != std::string_view("scene")) {
                const std::span all(family.inputs());
                std::ranges::for_each(all, run);
                std::ranges::for_each(all.first(std::min<std::size_t>(all.size(), 5'000)),
                                      trace); // traces are slow
            }
    }
};

} // namespace contract_test

TEST_CLASS(contract_test::ContractTest, None)
#include "tests/clipping/contract_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// clip, clipAll, count and trace agree; and if a window and a segment are mirrored,
// exchanged or reversed, the result is transformed in the same way.

#include "clipping/pseudo_code.h"

#include "tests/clipping/contract.h"
#include "tests/clipping/rows.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace uses_test {

using namespace clipping;

namespace {

/// Inputs with their window in common, as clipAll wants them.
struct Batch {
    std::vector<Segment> segments;
    Window window;
};
std::vector<Batch> batches(std::size_t mostOfEachFamily)
{
    std::vector<Batch> all;
    for (const Family& family : families()) {
        const auto& inputs = family.inputs();
        for (const auto& [segment, window] :
             std::span(inputs).first(std::min(inputs.size(), mostOfEachFamily))) {
            if (all.empty() || !(all.back().window == window))
                all.push_back({{}, window});
            all.back().segments.push_back(segment);
        }
    }
    return notEmpty(std::move(all));
}

std::vector<Form> formsOf(const Algorithm& algorithm)
{
    if (algorithm.published)
        return {Form::Corrected, Form::Published};
    return {Form::Corrected};
}

bool notLess(const OperationCounts& c, const OperationCounts& d)
{
    return c.additions >= d.additions && c.multiplications >= d.multiplications
           && c.divisions >= d.divisions && c.comparisons >= d.comparisons
           && c.negations >= d.negations;
}

/// The symmetries, each its own inverse.
struct Symmetry {
    const char* name;
    Input (*of)(const Input&);
    Segment (*back)(const Segment&);
};
Segment mirrorX(const Segment& s) { return {{-s.a.x, s.a.y}, {-s.b.x, s.b.y}}; }
Segment mirrorY(const Segment& s) { return {{s.a.x, -s.a.y}, {s.b.x, -s.b.y}}; }
Segment exchange(const Segment& s) { return {{s.a.y, s.a.x}, {s.b.y, s.b.x}}; }
Segment reverse(const Segment& s) { return {s.b, s.a}; }
const std::array symmetries{
    Symmetry{"mirrored in y",
             [](const Input& i) -> Input {
                 const auto& [low, high] = i.window;
                 return {mirrorX(i.segment), {{-high.x, low.y}, {-low.x, high.y}}};
             },
             mirrorX},
    Symmetry{"mirrored in x",
             [](const Input& i) -> Input {
                 const auto& [low, high] = i.window;
                 return {mirrorY(i.segment), {{low.x, -high.y}, {high.x, -low.y}}};
             },
             mirrorY},
    Symmetry{"x and y exchanged",
             [](const Input& i) -> Input {
                 const auto& [low, high] = i.window;
                 return {exchange(i.segment), {{low.y, low.x}, {high.y, high.x}}};
             },
             exchange},
    Symmetry{"turned round",
             [](const Input& i) -> Input {
                 return {reverse(i.segment), i.window};
             },
             reverse},
};

/// How a result and the result of the mirrored input, mirrored back, disagree.
std::string disagreement(const Algorithm& algorithm, const Symmetry& symmetry, const Input& input,
                         bool excused)
{
    const Input other = symmetry.of(input);
    const auto result = algorithm.corrected.clip(input.segment, input.window);
    auto mirrored = algorithm.corrected.clip(other.segment, other.window);
    if (mirrored)
        mirrored = symmetry.back(*mirrored);
    if (result.has_value() != mirrored.has_value())
        return excused ? "" : "seen only one way";
    if (!result)
        return {};
    const oracle::Part as{{{mirrored->a.x, mirrored->a.y}, {mirrored->b.x, mirrored->b.y}}, {}, {}};
    return ulpsOff(result, input, as) <= 2 * algorithm.ulps ? "" : "not the same ends";
}

} // namespace

class UsesTest : public QObject {
    Q_OBJECT

private slots:
    void clipAllAgreesWithClip_data() { everyAlgorithm(); }
    void clipAllAgreesWithClip()
    {
        QFETCH(const Algorithm*, algorithm);
        for (const Form form : formsOf(*algorithm))
            for (const auto& [segments, window] : batches(20'000)) {
                std::vector<Clipped> out(segments.size());
                out.resize(functionsOf(*algorithm, form)->clipAll(segments, window, out));
                auto next = out.begin();
                for (std::size_t i = 0; i < segments.size(); ++i) {
                    const auto piece = functionsOf(*algorithm, form)->clip(segments[i], window);
                    const bool written = next != out.end() && next->source == i;
                    if (written != piece.has_value())
                        QFAIL(exactly({segments[i], window}).c_str());
                    if (!piece)
                        continue;
                    if (!sameBits(*piece, next->segment))
                        QFAIL(exactly({segments[i], window}).c_str());
                    if (form == Form::Corrected)
                        if (!saysWhereItIsCut(*next, segments[i], window))
                            QFAIL(exactly({segments[i], window}).c_str());
                    ++next;
                }
                QVERIFY(next == out.end());
            }
    }

    void traceAgreesWithClip_data() { everyAlgorithm(); }
    void traceAgreesWithClip()
    {
        QFETCH(const Algorithm*, algorithm);
        for (const Form form : formsOf(*algorithm))
            for (const auto& [segments, window] : batches(3'000))
                for (const Segment& s : segments) {
                    const auto* uses = functionsOf(*algorithm, form);
                    const auto piece = uses->clip(s, window);
                    const Trace trace = uses->trace(s, window);
                    if (piece.has_value() != (trace.outcome == Outcome::Visible))
                        QFAIL(exactly({s, window}).c_str());
                    if (piece && !sameBits(*piece, trace.visible))
                        QFAIL(exactly({s, window}).c_str());
                    OperationCounts last;
                    for (const Step& step : trace.steps) {
                        if (!notLess(step.cost, last))
                            QFAIL(exactly({s, window}).c_str());
                        last = step.cost;
                    }
                    if (trace.steps.empty())
                        QFAIL(exactly({s, window}).c_str());
                    if (!notLess(uses->count({&s, 1}, window), last))
                        QFAIL(exactly({s, window}).c_str());
                }
    }

    void everyStepNamesALineOfThePseudoCode_data() { everyAlgorithm(); }
    void everyStepNamesALineOfThePseudoCode()
    {
        QFETCH(const Algorithm*, algorithm);
        for (const Form form : formsOf(*algorithm)) {
            const auto lines = linesOf(codeOf(*algorithm, form));
            QVERIFY2(!lines.empty(), "no pseudo-code");
            for (const Input& input : grid())
                for (const Step& step :
                     functionsOf(*algorithm, form)->trace(input.segment, input.window).steps)
                    if (lineOf(lines, step.label) == 0)
                        QFAIL(step.label.data());
        }
    }

    void countsAddUp_data() { everyAlgorithm(); }
    void countsAddUp()
    {
        QFETCH(const Algorithm*, algorithm);
        const auto batch = batches(1'000).front();
        OperationCounts sum;
        for (const Segment& s : batch.segments) {
            const auto one = algorithm->corrected.count({&s, 1}, batch.window);
            sum.additions += one.additions;
            sum.multiplications += one.multiplications;
            sum.divisions += one.divisions;
            sum.comparisons += one.comparisons;
            sum.negations += one.negations;
        }
        QVERIFY(sum == algorithm->corrected.count(batch.segments, batch.window));
    }

    void isSymmetric_data()
    {
        QTest::addColumn<const Algorithm*>("algorithm");
        QTest::addColumn<int>("index");
        for (const Algorithm& a : algorithms())
            for (std::size_t i = 0; i < symmetries.size(); ++i)
                QTest::addRow("%s %s", a.key.data(), symmetries[i].name) << &a << int(i);
    }
    void isSymmetric()
    {
        QFETCH(const Algorithm*, algorithm);
        QFETCH(int, index);
        const Symmetry& symmetry = symmetries[std::size_t(index)];
        for (const Family& family : families()) {
            const bool whole = family.name == std::string_view("grid");
            const auto& inputs = notEmpty(family.inputs());
            for (std::size_t i = 0; i < inputs.size() && i < 20'000; ++i) {
                const auto wrong = disagreement(*algorithm, symmetry, inputs[i], !whole);
                VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(inputs[i])).c_str());
            }
        }
    }

    // A new end of a horizontal or vertical line keeps the line's coordinate, bit for bit.
    void linesAlongAnAxisKeepTheirCoordinate_data() { everyAlgorithm(); }
    void linesAlongAnAxisKeepTheirCoordinate()
    {
        QFETCH(const Algorithm*, algorithm);
        const auto [segments, window] = batches(2'000).back(); // the paper's scene
        for (Segment s : segments) {
            s.b.x = s.a.x = s.a.x / 12;
            const auto vertical = algorithm->corrected.clip(s, window);
            VERIFY_OR_SAY(!vertical || (vertical->a.x == s.a.x && vertical->b.x == s.a.x),
                          exactly({s, window}).c_str());
            const Window turned{{window.min.y, window.min.x}, {window.max.y, window.max.x}};
            const auto level = algorithm->corrected.clip(exchange(s), turned);
            VERIFY_OR_SAY(!level || (level->a.y == s.a.x && level->b.y == s.a.x),
                          exactly({s, window}).c_str());
        }
    }

private:
    static bool on(Edge edge, const glm::dvec2& p, const Window& w)
    {
        return edge == Edge::Left     ? p.x == w.min.x
               : edge == Edge::Right  ? p.x == w.max.x
               : edge == Edge::Bottom ? p.y == w.min.y
                                      : edge == Edge::Top && p.y == w.max.y;
    }
    static bool saysWhereItIsCut(const Clipped& c, const Segment& whole, const Window& w)
    {
        const Edge a = cutEdgeOfA(c.cut), b = cutEdgeOfB(c.cut);
        return (a == Edge::NoEdge ? c.segment.a == whole.a : on(a, c.segment.a, w))
               && (b == Edge::NoEdge ? c.segment.b == whole.b : on(b, c.segment.b, w));
    }
};

} // namespace uses_test

TEST_CLASS(uses_test::UsesTest, None)
#include "tests/clipping/uses_test.moc"

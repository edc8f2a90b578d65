// SPDX-License-Identifier: GPL-3.0-or-later
// The published forms have the correctness, the faults and the cost of the printed algorithms.
#include <glm/geometric.hpp>

#include <array>
#include <cmath>

#include "tests/clipping/contract.h"
#include "tests/clipping/rows.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace published_test {

using namespace clipping;

namespace {

const Algorithm& row(std::string_view abbreviation) { return *findAlgorithm(abbreviation); }

/// A published fault and its counterexample: the form sees `published` there, if anything.
struct Counterexample {
    const char* name;
    std::string_view abbreviation;
    Input input;
    std::optional<Segment> published;
};

constexpr Window two{{0, 0}, {2, 2}}, one{{0, 0}, {1, 1}};
constexpr double u = 0x1p-52;

const std::array counterexamples{
    Counterexample{"X5 drops an edge", "Skala", {{{-1, 0}, {1, 0}}, two}, {}},
    Counterexample{"X6 drops a contact", "Skala", {{{-1, 0}, {0, 0}}, two}, {}},
    Counterexample{
        "X7 drops a long piece", "KWC", {{{100, 0}, {100.5, 300}}, {{0, 0}, {300, 300}}}, {}},
    Counterexample{"X8 drops an edge", "KWC", {{{0, 0}, {0, 1}}, two}, {}},
    Counterexample{"X8 drops a contact", "KWC", {{{-1, 0}, {0, 0}}, two}, {}},
    Counterexample{"X11 never ends", "CS", {{{1, 1}, {-1, -1}}, {{0.1, 0.1}, {3, 3}}}, {}},
    Counterexample{"X12 far outside, MD",
                   "MD",
                   {{{-1, 1 + 2 * u}, {3, 1 - u}}, one},
                   Segment{{5.0 / 3, 1}, {1, 1}}},
    Counterexample{"X12 far outside, Skala",
                   "Skala",
                   {{{-1, 1 + 2 * u}, {3, 1 - u}}, one},
                   Segment{{1, 1}, {4.0 / 3, 1}}},
    Counterexample{"X13 slope overflows", "MD", {{{-1e-300, -1e300}, {2e-300, 1e300}}, one}, {}},
    Counterexample{
        "drops a contact at a seventh", "MS", {{{-1, -4}, {6, 45}}, {{0, 0}, {3, 3}}}, {}},
    Counterexample{"X9 drops a contact", "SB", {{{-1, 0}, {0, 1}}, one}, {}},
    Counterexample{"product overflows", "SPY", {{{-1e200, -1e200}, {2e200, 2e200}}, one}, {}},
};

/// Counts as algorithms are compared by: comparisons, additions, multiplications, divisions.
using Counts = std::array<int, 4>;

/// What each row costs in one case, worked out by hand; window (-100, -75) to (100, 75).
struct Cost {
    const char* name;
    Segment segment;
    Counts cs, lb, cb, nln, skala, kwc, md, spy, sb;
};

// clang-format off
const std::array costs{
    Cost{"both inside", {{-50, -20}, {60, 30}}, {8}, {16, 6, 0, 4}, {15, 26, 16, 4}, {8}, {8}, {12, 6, 2, 2}, {14}, {8}, {9}},
    Cost{"both left", {{-200, 0}, {-150, 50}}, {6}, {2, 2, 0, 1}, {13, 26, 16, 4}, {2}, {6}, {10, 10, 4, 4}, {2}, {6}, {3}},
    Cost{"both above", {{-50, 100}, {60, 130}}, {8}, {13, 6, 0, 4}, {13, 26, 16, 4}, {4}, {8}, {12, 8, 2, 4}, {5}, {8}, {7}},
    Cost{"b right", {{0, 0}, {200, 30}}, {12, 4, 1, 1}, {16, 8, 2, 4}, {15, 28, 18, 4}, {8, 4, 1, 1}, {12, 14, 16, 2}, {12, 7, 3, 2}, {14, 4, 1, 1}, {8, 4, 1, 1}, {10, 6, 2, 1}},
    Cost{"b beyond a corner", {{0, 0}, {200, 100}}, {16, 8, 2, 2}, {16, 8, 2, 4}, {15, 28, 18, 4}, {9, 5, 2, 1}, {12, 14, 16, 2}, {12, 7, 3, 2}, {14, 4, 1, 1}, {9, 4, 1, 1}, {10, 6, 2, 1}},
    Cost{"a left", {{-200, 0}, {0, 30}}, {11, 4, 1, 1}, {16, 8, 2, 4}, {15, 28, 18, 4}, {8, 4, 1, 1}, {11, 14, 16, 2}, {11, 7, 3, 2}, {14, 4, 1, 1}, {7, 4, 1, 1}, {11, 6, 2, 1}},
    Cost{"left to right", {{-200, -20}, {200, 30}}, {15, 8, 2, 2}, {16, 10, 4, 4}, {15, 30, 20, 4}, {8, 6, 2, 2}, {11, 17, 22, 4}, {11, 8, 4, 2}, {14, 8, 2, 2}, {7, 8, 2, 2}, {12, 9, 3, 2}},
    Cost{"left to top", {{-200, 0}, {50, 100}}, {15, 8, 2, 2}, {16, 10, 4, 4}, {15, 30, 20, 4}, {9, 6, 2, 2}, {11, 17, 22, 4}, {11, 8, 3, 3}, {14, 8, 2, 2}, {8, 8, 2, 2}, {13, 9, 3, 2}},
    Cost{"bottom to top", {{-20, -100}, {30, 100}}, {15, 8, 2, 2}, {16, 10, 4, 4}, {15, 30, 20, 4}, {8, 6, 2, 2}, {11, 17, 22, 4}, {11, 8, 2, 4}, {14, 8, 2, 2}, {7, 8, 2, 2}, {12, 9, 3, 2}},
    Cost{"corner to corner", {{-200, -100}, {150, 150}}, {17, 12, 3, 3}, {16, 10, 4, 4}, {15, 30, 20, 4}, {10, 8, 4, 2}, {10, 17, 22, 4}, {11, 9, 4, 3}, {15, 12, 3, 3}, {10, 12, 3, 3}, {13, 11, 4, 2}},
    Cost{"past a corner", {{-200, 0}, {0, 200}}, {11, 4, 1, 1}, {13, 6, 0, 4}, {13, 26, 16, 4}, {8, 4, 2, 0}, {11, 11, 10, 0}, {11, 9, 3, 4}, {14, 12, 3, 3}, {8, 4, 1, 1}, {9, 5, 2, 0}},
    Cost{"corner to corner, past one", {{-200, -100}, {150, 600}}, {13, 8, 2, 2}, {13, 6, 0, 4}, {13, 26, 16, 4}, {8, 5, 3, 0}, {10, 11, 10, 0}, {11, 10, 4, 4}, {15, 16, 4, 4}, {7, 4, 1, 1}, {10, 7, 3, 0}},
    Cost{"horizontal", {{-200, 20}, {200, 20}}, {15, 8, 2, 2}, {15, 10, 4, 2}, {13, 30, 20, 2}, {8, 6, 2, 2}, {11, 17, 22, 4}, {9, 2, 0, 0}, {14, 8, 2, 2}, {7, 8, 2, 2}, {12, 9, 3, 2}},
    Cost{"vertical", {{30, -100}, {30, 100}}, {15, 8, 2, 2}, {15, 10, 4, 2}, {13, 30, 20, 2}, {8, 6, 2, 2}, {11, 17, 22, 4}, {9, 2, 0, 0}, {14, 8, 2, 2}, {7, 8, 2, 2}, {12, 9, 3, 2}},
    Cost{"a point inside", {{10, 10}, {10, 10}}, {8}, {14, 6, 0, 0}, {11, 26, 16, 0}, {8}, {8}, {6}, {14}, {8}, {9}},
};
// clang-format on

Counts of(const OperationCounts& c)
{
    return {int(c.comparisons), int(c.additions), int(c.multiplications), int(c.divisions)};
}

double total(const OperationCounts& c)
{
    return double(c.additions + c.multiplications + c.divisions + c.comparisons + c.negations);
}

/// The visible part is a contact, or lies along an edge: the published forms of Skala and
/// of Slater and Barsky may lose such a part.
bool onlyTouches(const oracle::Part& part, const Window& w)
{
    const auto& [a, b] = part.line;
    return (a.x == b.x && (a.y == b.y || a.x == w.min.x || a.x == w.max.x))
           || (a.y == b.y && (a.y == w.min.y || a.y == w.max.y));
}

/// The published form of Kodituwakku-Wijeweera-Chamikara drops parts shorter than 1, and
/// horizontal and vertical lines on an edge.
bool underOnePixel(const oracle::Part& part, const Segment& s, const Window& w)
{
    const auto& [a, b] = part.line;
    const bool vertical = s.a.x == s.b.x, horizontal = s.a.y == s.b.y;
    if (vertical && horizontal)
        return a.x <= w.min.x || a.x >= w.max.x || a.y <= w.min.y || a.y >= w.max.y;
    if (vertical)
        return s.a.x <= w.min.x || s.a.x >= w.max.x || std::abs(a.y - b.y) < 1;
    if (horizontal)
        return s.a.y <= w.min.y || s.a.y >= w.max.y || std::abs(a.x - b.x) < 1;
    return std::abs(a.x - b.x) < 1 - 1e-12;
}

} // namespace

class PublishedTest : public QObject {
    Q_OBJECT

private slots:
    void showsThePublishedFault_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < counterexamples.size(); ++i)
            QTest::newRow(counterexamples[i].name) << int(i);
    }
    void showsThePublishedFault()
    {
        QFETCH(int, index);
        const auto& [name, abbreviation, input, expected] = counterexamples[std::size_t(index)];
        const Algorithm& algorithm = row(abbreviation);
        const auto published = algorithm.published->clip(input.segment, input.window);
        QCOMPARE(published.has_value(), expected.has_value());
        if (expected) {
            QVERIFY(glm::distance(published->a, expected->a) < 1e-3);
            QVERIFY(glm::distance(published->b, expected->b) < 1e-3);
        }
        const auto truth = truthOf(input);
        QVERIFY(!fault(published, input, truth, algorithm.ulps).empty() || truth.has_value());
        QVERIFY(truth.has_value() != published.has_value());
        const auto corrected = algorithm.corrected.clip(input.segment, input.window);
        const auto wrong = fault(corrected, input, truth, algorithm.ulps);
        QVERIFY2(wrong.empty(), wrong.c_str());
        QVERIFY(!truth || corrected); // none of these is within the tolerance
    }

    void skalaKeepsALeftwardLineOnTheBottomEdge()
    {
        QVERIFY(row("Skala").published->clip({{1, 0}, {-1, 0}}, two));
    }

    void slaterAndBarskyDivideByZero() // X10
    {
        const Input input{{{2, 1}, {2, -1}}, two};
        const auto published = row("SB").published->clip(input.segment, input.window);
        QVERIFY(published && std::isnan(published->b.y));
        const auto corrected = row("SB").corrected.clip(input.segment, input.window);
        QVERIFY(corrected && sameBits(*corrected, Segment{{2, 1}, {2, 0}}));
    }

    void cohenSutherlandSaysThatItDidNotEnd()
    {
        const auto& [name, abbreviation, input, nothing] = counterexamples[5];
        const auto trace = row("CS").published->trace(input.segment, input.window);
        QVERIFY(trace.outcome == Outcome::DidNotEnd);
        QVERIFY(!row("CS").published->clip(input.segment, input.window));
        QVERIFY(row("CS").corrected.trace(input.segment, input.window).outcome == Outcome::Visible);
    }

    // Every published form is exactly right, except for the printed faults of Skala, of Kodituwakku
    // and others, of Slater and Barsky, and of Cyrus-Beck at a window without area.
    void onTheGrid_data() { everyAlgorithm(); }
    void onTheGrid()
    {
        QFETCH(const Algorithm*, algorithm);
        if (!algorithm->published)
            QSKIP("this row has no published form");
        const bool skala = algorithm->key == "skala", polygon = algorithm->key == "cyrus-beck";
        const bool kwc = algorithm->key == "kodituwakku-wijeweera-chamikara";
        const bool sb = algorithm->key == "slater-barsky";
        int lost = 0;
        for (const Input& input : grid()) {
            const auto& [s, w] = input;
            if (sb && s.a.x == s.b.x && s.a.x == w.max.x)
                continue; // 0 / 0
            if ((polygon || skala) && (w.min.x == w.max.x || w.min.y == w.max.y))
                continue;
            const auto truth = truthOf(input);
            auto result = algorithm->published->clip(s, w);
            if (kwc && truth)
                VERIFY_OR_SAY(underOnePixel(*truth, s, w) != result.has_value(),
                              exactly(input).c_str());
            if (truth && !result && (kwc || ((skala || sb) && onlyTouches(*truth, w)))) {
                ++lost;
                continue;
            }
            VERIFY_OR_SAY(truth.has_value() == result.has_value(), exactly(input).c_str());
            if (skala && result && glm::dot(result->b - result->a, s.b - s.a) < 0)
                std::swap(result->a, result->b); // it does not keep the order
            VERIFY_OR_SAY(ulpsOff(result, input, truth) < 8, exactly(input).c_str());
        }
        QCOMPARE(lost > 0, skala || kwc || sb);
    }

    void costsEqualTheHandCounts_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < costs.size(); ++i)
            QTest::newRow(costs[i].name) << int(i);
    }
    void costsEqualTheHandCounts()
    {
        QFETCH(int, index);
        const Cost& cost = costs[std::size_t(index)];
        const auto counted = [&](const char* abbreviation) {
            return of(
                row(abbreviation).published->count({&cost.segment, 1}, {{-100, -75}, {100, 75}}));
        };
        QVERIFY(counted("CS") == cost.cs);
        QVERIFY(counted("LB") == cost.lb);
        QVERIFY(counted("CB") == cost.cb);
        QVERIFY(counted("NLN") == cost.nln);
        QVERIFY(counted("Skala") == cost.skala);
        QVERIFY(counted("KWC") == cost.kwc);
        QVERIFY(counted("MD") == cost.md);
        QVERIFY(counted("SPY") == cost.spy);
        QVERIFY(counted("SB") == cost.sb);
    }

    // The means over the paper's scene, and a corrected form within a few per cent of its own.
    void costsOnThePapersSceneAreKnown_data()
    {
        QTest::addColumn<QByteArray>("abbreviation");
        QTest::addColumn<std::array<double, 4>>("mean");
        using Mean = std::array<double, 4>;
        QTest::newRow("CS") << QByteArray("CS") << Mean{8.8, 2.7, 0.7, 0.68};
        QTest::newRow("LB") << QByteArray("LB") << Mean{9.2, 5.0, 0.6, 2.78};
        QTest::newRow("CB") << QByteArray("CB") << Mean{13.3, 26.6, 16.6, 4.0};
        QTest::newRow("NLN") << QByteArray("NLN") << Mean{5.2, 2.1, 1.1, 0.31};
        QTest::newRow("Skala") << QByteArray("Skala") << Mean{7.6, 4.9, 5.4, 0.61};
        QTest::newRow("KWC") << QByteArray("KWC") << Mean{10.1, 9.5, 3.8, 3.78};
        QTest::newRow("MD") << QByteArray("MD") << Mean{7.4, 4.5, 1.1, 1.13};
        QTest::newRow("MS") << QByteArray("MS") << Mean{110.6, 36.7, 36.7, 0.0};
        QTest::newRow("SPY") << QByteArray("SPY") << Mean{6.9, 2.6, 0.7, 0.65};
        QTest::newRow("SB") << QByteArray("SB") << Mean{6.6, 2.9, 1.1, 0.31};
    }
    void costsOnThePapersSceneAreKnown()
    {
        QFETCH(QByteArray, abbreviation);
        using Mean = std::array<double, 4>;
        QFETCH(Mean, mean);
        std::vector<Segment> lines;
        for (const Input& input : scene())
            lines.push_back(input.segment);
        const Algorithm& algorithm = row(abbreviation.data());
        const Window w{{-100, -75}, {100, 75}};
        const auto published = algorithm.published->count(lines, w);
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(std::abs(of(published)[i] / double(lines.size()) - mean[i]) < 0.06);
        QVERIFY(total(algorithm.corrected.count(lines, w)) < 1.04 * total(published));
    }
};

} // namespace published_test

TEST_CLASS(published_test::PublishedTest, None)
#include "tests/clipping/published_test.moc"

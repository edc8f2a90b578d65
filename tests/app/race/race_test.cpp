// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/agreement.h"
#include "app/experiment/ranking.h"
#include "app/race/race.h"
#include "app/race/race_text.h"

#include <QTest>

#include <array>
#include <cmath>
#include <malloc.h>
#include <random>

#include "tests/app/scene/scene_lines_of.h"
#include "tests/not_empty.h"
#include "tests/sanitizer.h"
#include "tests/test_class.h"

namespace race_race_test {

using namespace clipping;

namespace {

const Window window{{-5, -4}, {5, 4}};

std::vector<Segment> scattered(std::size_t count)
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> x(-20, 20);
    std::vector<Segment> lines(count);
    for (Segment& s : lines)
        s = {{x(random), x(random)}, {x(random), x(random)}};
    return lines;
}

std::vector<app::Variant> everyForm()
{
    std::vector<const Algorithm*> all;
    for (const Algorithm& row : algorithms())
        all.push_back(&row);
    return app::variantsOf(all);
}

void run(app::Race& race, const app::RaceFrame& frame,
         app::Race::Purpose purpose = app::Race::Purpose::Findings)
{
    race.begin(frame, purpose);
    while (!race.step())
        QVERIFY(race.running());
    QVERIFY(!race.running());
}

std::vector<Clipped> clipped(const Functions<Segment, Window>& uses, std::span<const Segment> lines)
{
    std::vector<Clipped> pieces(lines.size());
    pieces.resize(uses.clipAll(lines, window, pieces));
    return pieces;
}

/// Each line clipped by itself, by `clip` instead of `clipAll`.
app::DifferenceCounts countedOneByOne(const app::Variant& variant, std::span<const Segment> lines,
                                      const Window& w)
{
    const double ulps = variant.algorithm->ulps + exactAlgorithm().ulps;
    app::DifferenceCounts counts;
    for (const Segment& line : lines) {
        const auto found = functionsOf(*variant.algorithm, variant.form)->clip(line, w);
        const auto truth = exactAlgorithm().corrected.clip(line, w);
        counts.onlyA += found && !truth;
        counts.onlyB += truth && !found;
        if (found && truth) {
            double most = 0;
            for (const double x :
                 {line.a.x, line.a.y, line.b.x, line.b.y, w.min.x, w.min.y, w.max.x, w.max.y})
                most = std::max(most, std::abs(x));
            const double allowed = ulps * (std::nextafter(most, 1e9) - most);
            const auto off = [&](const glm::dvec2& p, const glm::dvec2& q) {
                return !(std::abs(p.x - q.x) <= allowed && std::abs(p.y - q.y) <= allowed);
            };
            const bool straight = !off(found->a, truth->a) && !off(found->b, truth->b);
            const bool swapped = !off(found->a, truth->b) && !off(found->b, truth->a);
            counts.endsApart += !straight && !swapped;
        }
    }
    return counts;
}

double heapBytes()
{
    const auto info = ::mallinfo2();
    return double(info.uordblks + info.hblkhd);
}

// Variants whose calls are written down, and whose time is the test's.
std::vector<int> order;
double now = 0;

template <int who, int nanosecondsALine>
std::size_t clipAll(std::span<const Segment> in, const Window& w, std::span<Clipped> out)
{
    order.push_back(who);
    now += nanosecondsALine * double(in.size()) * (1 + 0.01 * double(order.size() % 7));
    return findAlgorithm("cs")->corrected.clipAll(in, w, out);
}

template <int who, int nanosecondsALine>
Algorithm named(std::string_view key)
{
    Algorithm row = *findAlgorithm("cs");
    row.key = key;
    row.corrected.clipAll = clipAll<who, nanosecondsALine>;
    return row;
}

struct ThreeRows {
    std::array<Algorithm, 3> rows{named<0, 50>("one"), named<1, 50>("other"),
                                  named<2, 80>("slower")};
    app::Race race{
        {{&rows[0], Form::Corrected}, {&rows[1], Form::Corrected}, {&rows[2], Form::Corrected}},
        {"the test's", [] { return now; }}};
    ThreeRows() { order.clear(); }
};

} // namespace

class RaceTest : public QObject {
    Q_OBJECT

private slots:
    /// Of one block of lines, and of several.
    void findsWhatClipAllFinds_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {0, 1, 5000, 40'000})
            QTest::addRow("%d lines", count) << count;
    }
    void findsWhatClipAllFinds()
    {
        QFETCH(int, count);
        const auto lines = scattered(std::size_t(count));
        const auto scene = sceneLinesOf(lines);
        app::Race race(everyForm());
        run(race, {scene, window});
        for (const app::RaceRow& row : notEmpty(race.rows())) {
            const auto* algorithm = row.variant.algorithm;
            const auto pieces = clipped(*functionsOf(*algorithm, row.variant.form), lines);
            const app::DifferenceCounts expected = countedOneByOne(row.variant, lines, window);
            QVERIFY2(row.visible == pieces.size(), algorithm->key.data());
            QVERIFY2(row.differences == expected, algorithm->key.data());
            QCOMPARE(row.milliseconds.size(), std::size_t(1));
            if (algorithm == &exactAlgorithm())
                QCOMPARE(row.differences.all(), std::size_t(0));
        }
    }
    void firstAlgorithmChangesFromRoundToRound()
    {
        ThreeRows t;
        const auto scene = sceneLinesOf(scattered(100));
        for (int i = 0; i < 4; ++i)
            run(t.race, {scene, window});
        QCOMPARE(order, (std::vector<int>{1, 2, 0, 2, 0, 1, 0, 1, 2, 1, 2, 0}));
    }
    void twoNamesOfOneFunctionDoNotDiffer()
    {
        ThreeRows t;
        const auto lines = scattered(1000);
        const auto scene = sceneLinesOf(lines);
        for (std::size_t i = 0; i < app::Race::length; ++i)
            run(t.race, {scene, window});
        std::vector<std::vector<double>> runs;
        for (const app::RaceRow& row : t.race.rows())
            runs.emplace_back(row.times().begin(), row.times().end());
        const auto ranking = app::rankingOf(runs);
        QCOMPARE(ranking.groupsOf(0), ranking.groupsOf(1));
        QCOMPARE(ranking.ranks[2], std::optional(3));
        const double median = t.race.rows()[0].summary().median;
        QVERIFY(std::abs(median - 0.05) < 0.005); // ms: 1000 lines at 50 ns
    }
    void roundsRunWithoutLinesToo()
    {
        ThreeRows t;
        for (int i = 0; i < 3; ++i)
            run(t.race, {{}, window});
        QCOMPARE(t.race.rounds(), std::size_t(3));
        QCOMPARE(t.race.rows()[0].milliseconds.size(), std::size_t(3));
    }
    void remembersTheLastRoundsOnly()
    {
        ThreeRows t;
        const auto scene = sceneLinesOf(scattered(10));
        for (std::size_t i = 0; i < app::Race::length + 3; ++i)
            run(t.race, {scene, window});
        QCOMPARE(t.race.rows()[0].milliseconds.size(), app::Race::length);
        QCOMPARE(t.race.rows()[0].ofThisFrame, app::Race::length);
        QCOMPARE(t.race.rounds(), app::Race::length + 3);
    }
    void anotherWindowIsAnotherFrameAndOtherLinesBeginAnew()
    {
        ThreeRows t;
        const auto scene = sceneLinesOf(scattered(10));
        for (int i = 0; i < 8; ++i)
            run(t.race, {scene, window});
        run(t.race, {scene, {{-1, -1}, {1, 1}}});
        QCOMPARE(t.race.rounds(), std::size_t(1));
        QCOMPARE(t.race.rows()[0].ofThisFrame, std::size_t(1));
        QCOMPARE(t.race.rows()[0].milliseconds.size(), std::size_t(9));
        run(t.race, {sceneLinesOf(scattered(11)), window});
        QCOMPARE(t.race.rows()[0].milliseconds.size(), std::size_t(1));
    }
    /// The times of other windows do not count as soon as this one's tell something.
    void theSummaryIsOfThisFrame()
    {
        app::RaceRow row{.variant = {&algorithms()[0], Form::Corrected},
                         .milliseconds = {9, 9, 9, 9, 9, 9, 9, 1, 1, 1, 1, 1, 1}};
        row.ofThisFrame = 5;
        QCOMPARE(row.summary().median, 9.0);
        row.ofThisFrame = 6;
        QCOMPARE(row.summary().median, 1.0);
    }
    void findingsMayComeLater()
    {
        const auto lines = scattered(2000);
        const auto scene = sceneLinesOf(lines);
        const app::Variant kwc{findAlgorithm("kwc"), Form::Published};
        app::Race race({{kwc.algorithm, kwc.form}});
        const Window other{{0, 0}, {9, 9}};
        const auto found = [&] { return race.rows()[0].differences; };
        run(race, {scene, window});
        run(race, {scene, other}, app::Race::Purpose::Times);
        QCOMPARE(race.rows()[0].visible, app::clipped(kwc, lines, window).size());
        QVERIFY(found() == countedOneByOne(kwc, lines, window));
        run(race, {scene, other});
        QCOMPARE(race.rows()[0].visible, app::clipped(kwc, lines, other).size());
        QVERIFY(found() == countedOneByOne(kwc, lines, other));
        QCOMPARE(race.rounds(), std::size_t(2));
    }
    void smallTimesTellSomething()
    {
        QCOMPARE(app::shortTimeText(0.42), "0.42 ms");
        QCOMPARE(app::shortTimeText(0.0301), "30.1 µs");
        QCOMPARE(app::shortTimeText(0.0004), "0.40 µs");
        QCOMPARE(app::shortTimeText(0), "0.00 µs");
    }
    void algorithmsWithoutADifferenceAreNamed()
    {
        const auto row = [](const char* name, Form form, double ms) {
            return app::RaceRow{.variant = {findAlgorithm(name), form},
                                .milliseconds = std::vector<double>(10, ms)};
        };
        const auto groups = [](std::span<const app::RaceRow> of) {
            return app::groupsText(of, app::rankingOf(of));
        };
        std::vector rows{row("cb", Form::Corrected, 9), row("lb", Form::Corrected, 2),
                         row("kwc", Form::Published, 2), row("cs", Form::Corrected, 1)};
        QCOMPARE(groups(rows),
                 "No significant difference of 1 % or more: LB and KWC as published");
        rows.push_back(row("nln", Form::Corrected, 1.005)); // slower in every round
        rows.push_back(row("md", Form::Corrected, 2));
        QCOMPARE(groups(rows), "No significant difference of 1 % or more: CS and NLN; LB, "
                                        "KWC as published and MD");
        QCOMPARE(groups(std::span(rows).first(2)), "");
        // Half of the rounds as LB, and half as MD: it differs from neither.
        rows = {row("lb", Form::Corrected, 2), row("nln", Form::Corrected, 3),
                row("md", Form::Corrected, 4)};
        rows[1].milliseconds = {2, 2, 2, 2, 2, 4, 4, 4, 4, 4};
        QCOMPARE(groups(rows),
                 "No significant difference of 1 % or more: LB and NLN; NLN and MD");
        for (app::RaceRow& one : rows)
            one.milliseconds.resize(6);
        QCOMPARE(groups(rows),
                 "Too few rounds: 3 algorithms need 7 rounds, but this race has 6.");
    }
    void keepsOnePieceForEachLine()
    {
        constexpr std::size_t count = 500'000;
        const auto scene = sceneLinesOf(scattered(count));
        const double before = heapBytes();
        app::Race race({{findAlgorithm("cs"), Form::Corrected}});
        run(race, {scene, window});
        const double bytes = (heapBytes() - before) / count;
        if (memoryCanBeLimited)
            QVERIFY2(bytes < sizeof(Clipped) + 4, qPrintable(QString::number(bytes)));
    }
    void droppedRacesLeaveNoResult()
    {
        ThreeRows t;
        const auto scene = sceneLinesOf(scattered(100));
        run(t.race, {scene, window});
        const std::size_t visible = t.race.rows()[0].visible;
        t.race.begin({scene, {{100, 100}, {101, 101}}});
        t.race.step();
        t.race.step();
        t.race.drop();
        QVERIFY(!t.race.running());
        QCOMPARE(t.race.rows()[0].visible, visible);
        QCOMPARE(t.race.rows()[0].milliseconds.size(), std::size_t(1));
        run(t.race, {scene, {{100, 100}, {101, 101}}});
        QCOMPARE(t.race.rows()[0].visible, std::size_t(0));
        QCOMPARE(t.race.rows()[0].differences.all(), std::size_t(0));
    }
    void operationsAreCountedOnMoreLinesTheSecondTime()
    {
        const auto lines = scattered(app::Race::thoroughSample);
        const auto scene = sceneLinesOf(lines);
        app::Race race({{findAlgorithm("md"), Form::Corrected}});
        const auto c = findAlgorithm("md")->corrected.count(lines, window);
        const double all = double(c.comparisons + c.additions + c.multiplications + c.divisions)
                           / double(lines.size());
        run(race, {scene, window});
        const double quick = race.rows()[0].operations;
        QVERIFY2(std::abs(quick / all - 1) < 0.2, qPrintable(QString::number(quick / all)));
        run(race, {scene, window});
        QCOMPARE(race.rows()[0].operations, all);
        run(race, {scene, window});
        QCOMPARE(race.rows()[0].operations, all);
    }
};

} // namespace race_race_test

TEST_CLASS(race_race_test::RaceTest, None)
#include "tests/app/race/race_test.moc"

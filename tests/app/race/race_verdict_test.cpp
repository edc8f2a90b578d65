// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/race/race_text.h"
#include "app/race/race_verdict.h"

#include <QTest>

#include "tests/app/race/race_rows.h"
#include "tests/test_class.h"

namespace race_race_verdict_test {

using enum clipping::Form;
using app::WindowNeeds;
using Kind = app::RaceStatement::Kind;

namespace {

constexpr std::size_t many = 5000;

std::optional<app::RaceStatement> statement(app::RaceOutcome outcome, Kind kind)
{
    const bool timed = !outcome.rows.front().milliseconds.empty();
    const app::Ranking ranking = timed ? app::rankingOf(outcome.rows) : app::Ranking{};
    outcome.ranking = &ranking;
    for (const app::RaceStatement& one : app::verdictOf(outcome))
        if (one.kind == kind)
            return one;
    return {};
}

app::RaceRow losing(const char* algorithm, clipping::Form form, std::size_t lines)
{
    app::RaceRow row = raceRow(algorithm, form, 2);
    row.differences.onlyB = lines;
    return row;
}

} // namespace

class RaceVerdictTest : public QObject {
    Q_OBJECT

private slots:
    void formsThatAgreeAreSaidToAgree()
    {
        std::vector rows{raceRow("cs", Corrected, 1), raceRow("ex", Corrected, 2),
                         raceRow("cs", Published, 3)};
        rows[0].visible = 6407;
        auto said =
            statement({.rows = rows, .lines = many, .where = "Rectangle 1"}, Kind::Agreement);
        QVERIFY(said);
        QCOMPARE(said->first, "All corrected forms agree in Rectangle 1.");
        QCOMPARE(said->rest, "So do the published forms. 6,407 lines are visible.");
        rows[2].differences.endsApart = 1;
        rows[0].visible = 1;
        said = statement({.rows = rows, .lines = many}, Kind::Agreement);
        QCOMPARE(said->first, "All corrected forms agree.");
        QCOMPARE(said->rest, "1 line is visible.");
        rows[0].differences.onlyA = 1;
        QVERIFY(!statement({.rows = rows, .lines = many}, Kind::Agreement));
        rows = {raceRow("cs", Published, 3)};
        QCOMPARE(statement({.rows = rows, .lines = many}, Kind::Agreement)->first,
                 "All published forms agree with exact arithmetic.");
    }
    void theLargestDifferenceComesFirst()
    {
        const std::vector rows{raceRow("ex", Corrected, 1), losing("skala", Published, 117),
                               losing("kwc", Published, 2108)};
        const auto said = statement({.rows = rows, .lines = many}, Kind::Differences);
        QVERIFY(said);
        QCOMPARE(said->first, "KWC as published loses 2,108 lines that exact keeps.");
        QCOMPARE(said->rest, "Skala as published loses 117 lines that exact keeps.");
        QVERIFY(said->variant == rows[2].variant);
        QVERIFY(!statement({.rows = std::span(rows).first(1), .lines = many}, Kind::Differences));
    }
    void manyDifferencesAreCounted()
    {
        const std::vector rows{losing("cs", Published, 5), losing("lb", Published, 4),
                               losing("cb", Published, 3), losing("md", Published, 2),
                               losing("ms", Published, 1)};
        const auto said = statement({.rows = rows, .lines = many}, Kind::Differences);
        QVERIFY(said->rest.endsWith("CB as published loses 3 lines that exact keeps. 2 other forms "
                                    "differ on no more lines."));
        QCOMPARE(said->rest.count("loses"), 2);
        // Also of as many lines.
        const std::vector alike{losing("cs", Published, 7), losing("lb", Published, 7),
                                losing("cb", Published, 7), losing("md", Published, 7)};
        QVERIFY(statement({.rows = alike, .lines = many}, Kind::Differences)
                    ->rest.endsWith("1 other form differs on no more lines."));
    }
    void algorithmsThatCannotClipAWindowLoseNothingThere()
    {
        std::vector rows{raceRow("ex", Corrected, 1), raceRow("cs", Corrected, 1),
                         raceRow("cb", Corrected, 1), raceRow("cs", Published, 1)};
        const std::vector<app::NamedNeeds> windows{{"Rectangle 1", WindowNeeds::Rectangle},
                                                   {"Star 2", WindowNeeds::AnyArea},
                                                   {"Hexagon 3", WindowNeeds::ConvexPolygon},
                                                   {"Star 4", WindowNeeds::AnyArea}};
        const auto first = [&](std::size_t count) {
            const auto said =
                statement({.rows = rows, .lines = many, .windows = std::span(windows).first(count)},
                          Kind::Limits);
            return said ? said->first + u'|' + said->rest : QString();
        };
        QCOMPARE(first(1), "");
        QCOMPARE(first(2),
                 "2 algorithms cannot clip Star 2.|They leave it alone, and its lines are "
                 "not counted for them: nothing there is lost.");
        QVERIFY(first(4).startsWith("2 algorithms cannot clip Star 2 and Star 4.|CS cannot clip "
                                    "Hexagon 3. Such a window is left alone"));
        for (app::RaceRow& row : rows) // where nothing was measured, that alone is known
            row.milliseconds.clear();
        QCOMPARE(app::verdictOf({.rows = rows, .windows = windows}).size(), std::size_t(1));
        rows = {raceRow("cs", Published, 1)};
        QVERIFY(first(2).startsWith("None of these forms can clip Star 2."));
    }
    void timesThatTieAreNamed()
    {
        std::vector rows{raceRow("cs", Corrected, 0.23), raceRow("lb", Corrected, 0.9),
                         raceRow("kwc", Corrected, 0.23), raceRow("ex", Corrected, 0.1)};
        auto said = statement({.rows = rows, .lines = many}, Kind::Ties);
        QVERIFY(said);
        QCOMPARE(said->first, "CS and KWC tie at about 0.23 ms.");
        QCOMPARE(said->rest, "No test finds 1 % or more between them, so their order says nothing. "
                             "EX is fastest here.");
        rows.push_back(raceRow("md", Corrected, 0.9));
        said = statement({.rows = rows, .lines = many}, Kind::Ties);
        QVERIFY(said->rest.contains("nothing. LB and MD tie, too. EX is fastest"));
        rows = {rows[0], rows[1]};
        said = statement({.rows = rows, .lines = many}, Kind::Ties);
        QCOMPARE(said->first, "No two of these times tie.");
        QCOMPARE(said->rest, "CS is fastest here.");
        for (app::RaceRow& row : rows)
            row.milliseconds.resize(3);
        said = statement({.rows = rows, .lines = many}, Kind::Ties);
        QCOMPARE(said->first, "It is too early to rank the times.");
        QCOMPARE(said->rest, "3 of the 6 rounds that it takes are done.");
    }
    void whatTiesIsNotCalledTheFastest()
    {
        const std::vector rows{raceRow("cs", Corrected, 0.23), raceRow("lb", Corrected, 0.9)};
        app::Ranking ranking = app::rankingOf(rows);
        QVERIFY(ranking.hasFastest() && ranking.groups.size() == 2);
        ranking.groups = {{0, 1}};
        ranking.pairs[1][0].outcome = app::Outcome::NotSignificant;
        app::RaceOutcome outcome{.rows = rows, .lines = many};
        outcome.ranking = &ranking;
        const auto said = app::verdictOf(outcome);
        QCOMPARE(said.back().first, "CS and LB tie at 0.23 ms to 0.90 ms.");
        QVERIFY(!said.back().rest.contains("fastest"));
    }
    void fewLinesAreNotTimed()
    {
        const std::vector rows{raceRow("cs", Corrected, 0.23)};
        const auto said = statement({.rows = rows, .lines = 74}, Kind::Untimed);
        QVERIFY(said);
        QCOMPARE(said->first, "74 lines are too few to time.");
        QVERIFY(said->rest.contains("1,000 lines"));
        QVERIFY(!statement({.rows = rows, .lines = 74}, Kind::Ties));
        QVERIFY(!statement({.rows = rows, .lines = many}, Kind::Untimed));
        const auto nothing = app::verdictOf({.rows = rows, .lines = 0});
        QCOMPARE(nothing.size(), std::size_t(1));
        QCOMPARE(nothing.front().first, "There are no lines to compare.");
    }
    /// Five paragraphs are the most that the panel has room for.
    void everyKindIsSaidAtMostOnceAndInOrder()
    {
        const std::vector rows{raceRow("ex", Corrected, 1), losing("kwc", Published, 3)};
        const std::vector<app::NamedNeeds> windows{{"Star 2", WindowNeeds::AnyArea}};
        const app::Ranking ranking = app::rankingOf(std::span(rows));
        const auto all =
            app::verdictOf({.rows = rows, .lines = many, .windows = windows, .ranking = &ranking});
        QCOMPARE(all.size(), std::size_t(4));
        QCOMPARE(app::verdictOf({.rows = rows, .lines = many, .windows = windows}).size(),
                 std::size_t(3)); // which times tie is known later
        QVERIFY(std::ranges::is_sorted(all, std::less(), &app::RaceStatement::kind));
        for (const app::RaceStatement& one : all)
            QVERIFY2(one.first.endsWith(u'.'), qPrintable(one.first));
    }
};

} // namespace race_race_verdict_test

TEST_CLASS(race_race_verdict_test::RaceVerdictTest, Core)
#include "tests/app/race/race_verdict_test.moc"

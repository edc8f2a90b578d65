// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/race/race_lane.h"
#include "app/race/race_text.h"

#include <QTest>

#include "tests/app/race/race_rows.h"
#include "tests/test_class.h"

namespace race_race_pairs_test {

using enum clipping::Form;

/// What the table of a race shows: one row for each algorithm, on one scale.
class RacePairsTest : public QObject {
    Q_OBJECT

private slots:
    void theFormsOfAnAlgorithmAreOnePair()
    {
        const std::vector rows{raceRow("cs", Corrected, 2), raceRow("ex", Corrected, 1),
                               raceRow("lb", Corrected, 4), raceRow("cs", Published, 3),
                               raceRow("lb", Published, 5)};
        const auto pairs = app::pairsOf(rows);
        QCOMPARE(pairs.size(), std::size_t(3));
        QCOMPARE(pairs[0].algorithm, clipping::findAlgorithm("cs"));
        QCOMPARE(pairs[1].algorithm, clipping::findAlgorithm("ex"));
        QCOMPARE(pairs[2].algorithm, clipping::findAlgorithm("lb"));
        QCOMPARE(pairs[0].of(Corrected)->summary.median, 2.);
        QCOMPARE(pairs[0].of(Published)->summary.median, 3.);
        QVERIFY(!pairs[1].published);
        QCOMPARE(pairs[0].judged().row.variant.form, Published);
        QCOMPARE(pairs[0].ablest().row.variant.form, Corrected);
        QCOMPARE(pairs[1].judged().row.variant.form, Corrected);
        QVERIFY(app::anyIn(pairs, Published));
        QVERIFY(!app::anyIn(std::span(pairs).subspan(1, 1), Published));
        const auto last = app::pairsOf(std::span(rows).last(2));
        QVERIFY(!app::anyIn(last, Corrected));
        QCOMPARE(last[1].ablest().row.variant.form, Published);
    }
    void lanesEndAtARoundNumber_data()
    {
        QTest::addColumn<double>("longest");
        QTest::addColumn<QString>("end");
        QTest::addColumn<QString>("number");
        QTest::addRow("nothing") << 0. << "0 ms"
                                 << "0";
        QTest::addRow("0.4 µs") << 0.0004 << "500 ns"
                                << "400";
        QTest::addRow("50.7 µs") << 0.0507 << "100 µs"
                                 << "50.7";
        QTest::addRow("0.183 ms") << 0.18312 << "200 µs"
                                  << "183";
        QTest::addRow("0.5 ms") << 0.5 << "500 µs"
                                << "500";
        QTest::addRow("0.51 ms") << 0.51 << "1 ms"
                                 << "0.510";
        QTest::addRow("1 ms") << 1. << "1 ms"
                              << "1.00";
        QTest::addRow("1.01 ms") << 1.01 << "2 ms"
                                 << "1.01";
        QTest::addRow("9.996 ms") << 9.996 << "10 ms"
                                  << "10.0";
        QTest::addRow("0.9999 s") << 999.9 << "1 s"
                                  << "1.00";
        QTest::addRow("30 s") << 30e3 << "50 s"
                              << "30.0";
        QTest::addRow("2345 s") << 2345e3 << "5,000 s"
                                << "2,345";
    }
    void lanesEndAtARoundNumber()
    {
        QFETCH(double, longest);
        const auto lane = app::laneOf(app::pairsOf(
            std::vector{raceRow("cs", Corrected, longest / 2), raceRow("cs", Published, longest)}));
        QTEST(lane.end(), "end");
        QTEST(lane.number(longest, 3), "number");
        if (longest > 0)
            QCOMPARE(lane.share(lane.most), 1.);
        QCOMPARE(lane.share(lane.most / 4), longest > 0 ? 0.25 : 0);
        QCOMPARE(lane.share(2 * lane.most), longest > 0 ? 1. : 0);
    }
    void fewerDigitsKeepTheUnit()
    {
        const app::RaceLane lane{1};
        QCOMPARE(lane.text(0.23456), "0.235 ms");
        QCOMPARE(lane.text(0.23456, 2), "0.23 ms");
        QCOMPARE(lane.text(0.23456, 1), "0.2 ms");
        QCOMPARE(lane.text(0.0004567), "0.000457 ms");
        QCOMPARE(lane.text(123.4, 2), "123 ms");
        QCOMPARE(lane.text(0), "0 ms");
    }
    /// A time that sways about a round number does not change the scale with every round.
    void lanesDoNotJump()
    {
        const auto after = [](double longest, const app::RaceLane& before) {
            return app::laneOf(app::pairsOf(std::vector{raceRow("cs", Corrected, longest)}), before)
                .most;
        };
        QCOMPARE(after(0.21, {0.2}), 0.5);
        QCOMPARE(after(0.19, {0.5}), 0.5);
        QCOMPARE(after(0.17, {0.5}), 0.2);
        QCOMPARE(after(0.21, {1}), 0.5);
        QCOMPARE(after(0.95, {1000}), 1.); // whatever was measured before
        QCOMPARE(after(0.19, {20}), 0.2);
        QCOMPARE(after(0.95, {2}), 2.);
        QCOMPARE(after(0, {0.5}), 0.);
    }
    void longNamesHaveABriefForm()
    {
        const auto brief = [](const char* key) {
            return app::briefName(*clipping::findAlgorithm(key));
        };
        QCOMPARE(brief("kwc"), "Kodituwakku et al.");
        QCOMPARE(brief("spy"), "Sobkow et al.");
        QCOMPARE(brief("nln"), "Nicholl-Lee-Nicholl"); // two names
        QCOMPARE(brief("cs"), "Cohen-Sutherland");
        QCOMPARE(brief("wn"), "Winding number");
    }
    void legendsSayWhichWindowTheNumbersAreOf()
    {
        QCOMPARE(app::placeText({}, {1}), "");
        QCOMPARE(app::placeText("Star 2", {1}), "ms and differences: Star 2 only, all can clip it");
        QCOMPARE(app::placeText("Star 2", {}), "Differences: Star 2 only, all can clip it");
    }
    void everyNumberOfAFormIsInItsText()
    {
        app::RaceRow row = raceRow("kwc", Published, 0.2);
        row.milliseconds.back() = 0.4;
        row.operations = 7.06;
        row.visible = 8173;
        row.differences.onlyB = 2108;
        const app::FormResult result{row, row.summary()};
        QCOMPARE(app::figuresText(result, true),
                 "As published: 0.20 ms ± 0.00 µs, 7.1 operations per line, 8,173 visible lines, "
                 "2,108 differ");
        QCOMPARE(app::figuresText(result, false),
                 "As published: 7.1 operations per line, 8,173 visible lines, 2,108 differ");
        QCOMPARE(app::figuresText({{.variant = row.variant}, {}}, true), "");
    }
};

} // namespace race_race_pairs_test

TEST_CLASS(race_race_pairs_test::RacePairsTest, Core)
#include "tests/app/race/race_pairs_test.moc"

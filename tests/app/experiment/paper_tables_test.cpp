// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/paper_tables.h"
#include "app/view/numbers.h"

#include <QTest>

#include <cmath>
#include <numeric>

namespace {

double mean(const std::vector<double>& numbers)
{
    return std::accumulate(numbers.begin(), numbers.end(), 0.0) / double(numbers.size());
}

/// As the paper prints it. A hair is added for halves that binary numbers put below themselves.
QString rounded(double number, int decimals)
{
    return QString::number(number + 1e-9, 'f', decimals);
}

app::Record quickRecord(const app::PaperTable& paper, clipping::Form form)
{
    app::ExperimentOptions options;
    options.lines = 20'000;
    options.runs = 4;
    options.easel = app::rasterEasel;
    return *app::recorded(options, app::contestants(paper, form));
}

} // namespace

class PaperTablesTest : public QObject {
    Q_OBJECT

private slots:
    void theDataAreThePapers()
    {
        const auto tables = app::paperTables();
        QCOMPARE(tables.size(), 2u);
        QCOMPARE(tables[0].lines, 1'000'000u);
        QCOMPARE(tables[1].lines, 10'000'000u);
        for (const auto& table : tables) {
            QStringList names;
            for (const auto& column : table.columns) {
                names << column.name;
                QCOMPARE(column.runs.size(), 10u);
                QVERIFY(column.algorithm && column.algorithm->published);
            }
            QCOMPARE(names.join(' '), "CS LB CB NLN Skala KWC Prop.");
            QCOMPARE(QByteArray(table.columns.back().algorithm->abbreviation.data()), "MD");
        }
        // Some, as they stand in the paper.
        QCOMPARE(tables[0].columns[0].runs[0], 1.302);
        QCOMPARE(tables[0].columns[4].runs[9], 1.456);
        QCOMPARE(tables[1].columns[2].runs[5], 14.269);
        QCOMPARE(tables[1].columns[6].runs[1], 10.138);
    }

    void allFourteenAveragesFollowFromTheRuns()
    {
        int averages = 0;
        for (const auto& table : app::paperTables())
            for (const auto& column : table.columns) {
                QCOMPARE(rounded(mean(column.runs), 3), rounded(column.printedAverage, 3));
                ++averages;
            }
        QCOMPARE(averages, 14);
    }

    void allTwelvePercentagesFollowFromTheAverages()
    {
        int percentages = 0;
        for (const auto& table : app::paperTables()) {
            const double proposed = table.columns.back().printedAverage;
            QVERIFY(!table.columns.back().printedPercentage);
            for (const auto& column : std::span(table.columns).first(6)) {
                const double faster = app::fasterByProposed(column.printedAverage, proposed);
                QCOMPARE(rounded(faster, 2), rounded(*column.printedPercentage, 2));
                ++percentages;
            }
        }
        QCOMPARE(percentages, 12);
    }

    void theOtherDefinition()
    {
        // algorithms.md, section 3: relative to the previous method's time.
        const std::array table1{"14.7", "7.2", "21.2", "19.4", "11.1", "6.4"};
        const auto columns = app::paperTables()[0].columns;
        for (std::size_t i = 0; i < table1.size(); ++i)
            QCOMPARE(rounded(app::fasterByOther(columns[i].printedAverage, 1.165), 1), table1[i]);
        QCOMPARE(app::fasterByOther(2, 1), 50.0);
        QCOMPARE(app::fasterByProposed(2, 1), 100.0);
        QCOMPARE(app::fasterByProposed(1, 2), -50.0);
    }

    void thePapersOwnTableLooksLikeThePapers()
    {
        const auto table = app::paperLayout(app::paperTables()[0]);
        QCOMPARE(table.names.join(' '), "Exec. CS LB CB NLN Skala KWC Prop.");
        QCOMPARE(table.rows.size(), 11u);
        QCOMPARE(table.rows[0].join(' '), "1 1.302 1.264 1.446 1.577 1.234 1.216 1.182");
        QCOMPARE(table.rows[3].join(' '), "4 1.359 1.460 1.530 1.446 1.239 1.271 1.176");
        // 1.2555 and 1.1645 as printed; the rest as well.
        QCOMPARE(table.rows[10][0], "Avg:");
        QCOMPARE(table.rows[10][1], "1.365");
        QCOMPARE(table.rows[10][5], "1.310");
    }

    void oursHasThePapersLayoutForEachMeasure()
    {
        for (const auto form : {clipping::Form::Published, clipping::Form::Corrected}) {
            const auto paper = app::paperTables()[0];
            const auto record = quickRecord(paper, form);
            for (const auto& measure : app::measures()) {
                const auto table = app::paperLayout(paper, record, measure);
                QCOMPARE(table.names.join(' '), "Exec. CS LB CB NLN Skala KWC Prop.");
                QCOMPARE(table.rows.size(), 5u);
                QVERIFY(table.title.contains(measure.name)
                        && table.title.contains(app::countText(20'000) + " lines"));
                QVERIFY(table.title.contains(app::wordOf(form)));
                for (qsizetype c = 1; c < 8; ++c) {
                    double sum = 0;
                    for (std::size_t r = 0; r < 4; ++r)
                        sum += table.rows[r][c].toDouble();
                    QVERIFY(sum > 0);
                    QVERIFY(std::abs(sum / 4 - table.rows[4][c].toDouble()) < 2e-3 * sum + 2e-6);
                }
                const bool losing = table.notes.join(' ').contains("KWC loses");
                QCOMPARE(losing, form == clipping::Form::Published);
            }
        }
    }

    void againstThePaper()
    {
        const auto paper = app::paperTables()[1];
        const auto record = quickRecord(paper, clipping::Form::Published);
        const auto measure = app::measures()[2];
        const auto table = app::againstPaper(paper, record, measure);
        QCOMPARE(table.rows.size(), 7u);
        QVERIFY(table.notes.join(' ').contains("Not the same work"));
        const auto& nln = table.rows[3];
        QCOMPARE(nln[0], "NLN");
        QCOMPARE(nln[1], "12.969");
        QCOMPARE(nln[5], "24.37");
        QCOMPARE(nln[7], "19.59");
        const auto summaries = app::summaries(record, measure);
        const double ours = app::fasterByProposed(summaries[3].mean, summaries[6].mean);
        QCOMPARE(nln[6], QString::number(ours, 'f', 2));
        QCOMPARE(table.rows[6].sliced(5), QStringList({"", "", "", ""}));
        // Its own runs put Prop. first beyond doubt. The fastest of CB is within NLN's slowest.
        QCOMPARE(table.rows[6][3], "1");
        QCOMPARE(table.rows[2][3], table.rows[3][3]);
        QVERIFY(table.rows[2][3].startsWith("tie"));
    }

    void whatIsNotTheSameWorkIsToldSo()
    {
        const auto paper = app::paperTables()[0];
        const auto clip = app::measures().front(), total = app::measures().back();
        QCOMPARE(total.key, "total");
        app::ExperimentOptions options;
        options.lines = paper.lines;
        QCOMPARE(app::otherWorkText(paper, options, total), "");
        QVERIFY(app::otherWorkText(paper, options, clip).contains(clip.name));
        options.lines = 20'000;
        const QString fewer = app::otherWorkText(paper, options, total);
        QVERIFY2(fewer.contains(app::countText(1'000'000) + " random lines")
                     && fewer.contains(app::countText(20'000) + " lines."),
                 qPrintable(fewer));
        options.scene = *app::findTestScene(u"long");
        QVERIFY(app::otherWorkText(paper, options, total).contains("lines of the scene “Long”"));
        QCOMPARE(app::otherLinesText(options), "lines of the scene “Long”");
        options = {};
        options.field.window.max.x += 1;
        QVERIFY(!app::otherLinesText(options).isEmpty());
    }

    void theRankingInWords()
    {
        const std::vector<app::Summary> summaries{{.median = 5, .confidence = {4, 6}},
                                                  {.median = 1, .confidence = {1, 1}},
                                                  {.median = 4, .confidence = {3, 5}},
                                                  {.median = 9, .confidence = {8, 9}}};
        QVERIFY(app::rankingText({"A", "B", "C", "D"}, summaries).endsWith(": B < C = A < D."));
        // E overlaps A, but not C.
        auto chain = summaries;
        chain.push_back({.median = 5.8, .confidence = {5.5, 6.5}});
        const QString told = app::rankingText({"A", "B", "C", "D", "E"}, chain);
        QVERIFY2(told.endsWith(": B < (C = A) (A = E) < D."), qPrintable(told));
        QVERIFY(told.contains("not in the same brackets"));
        QCOMPARE(app::placeText(app::standings(chain)[0]), "tie a b");
        QCOMPARE(app::tieLetter(27), "ab");
    }
};

QTEST_GUILESS_MAIN(PaperTablesTest)
#include "paper_tables_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/study_charts.h"
#include "app/command_line/bench_plan.h"
#include "app/report/repeat.h"
#include "app/report/study_report.h"

#include <QProcess>
#include <QTest>

#include <algorithm>

#include "tests/test_class.h"

namespace report_study_report_test {

namespace {

/// What `clearcut bench` makes of these arguments.
app::ParsedArguments parsedBench(const QStringList& arguments)
{
    for (const app::Command& command : app::commands())
        if (command.key == "bench")
            return {command, arguments};
    qFatal("no bench");
}

app::Plan planOf(const QStringList& arguments)
{
    const app::ParsedArguments given = parsedBench(arguments);
    return app::parsedPlan(given, app::parsedWanted(given, QStringLiteral("clip")));
}

app::Study studyOf(const QStringList& arguments)
{
    app::Plan plan = planOf(arguments);
    if (arguments.join(u' ').contains(u"accuracy"))
        plan.explained = app::explanationOf(plan);
    return *app::study(plan);
}

QString factsText(const app::ExperimentOptions& options)
{
    QStringList facts;
    for (const auto& [name, value] : app::factsOf(app::Record{options, {}, {}, {}}))
        facts << name + u'=' + value;
    return facts.join(u' ');
}

} // namespace

class StudyReportTest : public QObject {
    Q_OBJECT

private slots:
    void everythingIsInTheReport()
    {
        const auto study = studyOf({"--paper", "all", "--lines", "2000", "--runs", "3", "--form",
                                    "both", "--measure", "clip,total,accuracy"});
        const app::Report report = app::reportOf(study);
        QVERIFY(report.summary[0].contains("Cohen-Sutherland (CS), "));
        QVERIFY(report.summary[0].contains(", Skala, "));
        for (const char* trial :
             {"Table 1, as published, 2,000 lines. The paper clipped 1,000,000 lines, not 2,000.",
              "Table 2, corrected, 2,000 lines. The paper clipped 10,000,000 lines, not 2,000."})
            QCOMPARE(report.summary.filter(trial).size(), 1);
        QStringList titles, tables, charts;
        for (const app::ReportSection& section : report.sections) {
            QVERIFY(!section.title.isEmpty());
            titles << section.title;
            for (const app::Table& table : section.tables)
                tables << table.key;
            for (const app::Chart& chart : section.charts)
                charts << chart.key;
        }
        QCOMPARE(titles.size(), 4 + 4); // trials; the paper's own, why, how, again
        titles.removeDuplicates();
        QCOMPARE(titles.size(), 8);
        for (const char* key : {"table1-paper", "table2-paper", "table1-clip-published",
                                "table2-total-corrected", "table1-clip-corrected-against-paper",
                                "classes", "operations", "accuracy", "circumstances"})
            QVERIFY2(tables.contains(QLatin1StringView(key)), key);
        for (const app::Chart& chart : app::chartsOf(study))
            QVERIFY2(charts.contains(chart.key), qPrintable(chart.key));
        charts.removeDuplicates();
        QCOMPARE(std::size_t(charts.size()), app::chartsOf(study).size());
    }

    void sharedFactsAreStatedOnce()
    {
        const auto report = app::reportOf(studyOf({"-n", "1000", "-r", "2", "-a", "cs,md"}));
        for (const app::ReportSection& section : report.sections)
            for (const app::Table& table : section.tables)
                QVERIFY2(table.facts.empty(), qPrintable(table.key));
        const auto& how = report.sections[report.sections.size() - 2];
        QVERIFY(std::ranges::find(how.tables[0].rows, QStringList{"seed", "1"})
                != how.tables[0].rows.end());
    }

    void theCommandRepeatsTheStudy_data()
    {
        QTest::addColumn<QString>("arguments");
        for (const char* arguments :
             {"-n 1000 -r 2", "-n 1000 -r 2 -a cs,md --form corrected --seed 7 --warmup 2",
              "-n 900 -r 1 --scene near-miss --order sorted --window=-10,-20,30,40",
              "-n 900 -r 2 --precision single --measure clip,total --draw-with raster",
              "--paper table1 -n 1000 -r 2", "--paper all -n 1000 -r 2 --form both",
              "--paper table2 -n 1000 -r 2 --form corrected --measure clip,accuracy",
              "--scene file:" SOURCE_DIR "/resources/samples/rosette.svg -r 1 -a cs"})
            QTest::newRow(arguments) << QString::fromUtf8(arguments);
    }
    void theCommandRepeatsTheStudy()
    {
        QFETCH(QString, arguments);
        const QString samples = SOURCE_DIR "/resources/samples/";
        const auto study = studyOf(QProcess::splitCommand(arguments));
        QStringList words = QProcess::splitCommand(app::commandToRepeat(study));
        QCOMPARE(words.mid(0, 2), (QStringList{"clearcut", "bench"}));
        QCOMPARE(words.takeLast(), "--report=report.html");
        words.replaceInStrings("file:", "file:" + samples);
        const auto plan = planOf(words.mid(2));
        QCOMPARE(plan.trials.size(), study.trials.size());
        for (std::size_t i = 0; i < plan.trials.size(); ++i) {
            const app::Record& record = study.trials[i].record;
            QCOMPARE(factsText(plan.trials[i].options), factsText(record.options));
            QCOMPARE(plan.trials[i].variants.size(), record.timings.size());
            for (std::size_t c = 0; c < record.timings.size(); ++c)
                QVERIFY(plan.trials[i].variants[c] == record.timings[c].variant);
        }
        for (std::size_t m = 0; m < plan.measures.size(); ++m)
            QCOMPARE(plan.measures[m].key, study.measures[m].key);
    }

    void wordsAreQuotedForAShell()
    {
        auto study = studyOf({"-n", "1000", "-r", "1", "-a", "cs"});
        study.trials[0].record.options.scene = app::repeatedScene("it's; $HOME \"x\".svg", {{}});
        QVERIFY(app::commandToRepeat(study).contains("'--scene=file:it'\\''s; $HOME \"x\".svg'"));
    }
};

} // namespace report_study_report_test

TEST_CLASS(report_study_report_test::StudyReportTest, Gui)
#include "tests/app/report/study_report_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/progress.h"
#include "app/experiment/choice.h"
#include "app/experiment/heading.h"
#include "app/experiment/verdict.h"
#include "app/scene/scene.h"

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <limits>
#include <set>
#include <thread>

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"

namespace experiment_study_test {

using clipping::Form;

namespace {

app::Subject subject(const QString& key)
{
    for (app::Subject& one : app::subjects())
        if (one.key == key)
            return std::move(one);
    qFatal("no such subject");
}

std::vector<const clipping::Algorithm*> named(std::initializer_list<const char*> names)
{
    std::vector<const clipping::Algorithm*> all;
    for (const char* name : names)
        all.push_back(clipping::findAlgorithm(name));
    return all;
}

app::Choice few(const QString& key)
{
    app::Choice choice{.subject = subject(key)};
    choice.lines = 1000;
    choice.runs = 2;
    choice.algorithms = named({"cs", "kwc", "md"});
    return choice;
}

/// A record as if it had been measured: so many nanoseconds a line, the same in every run but for a
/// tenth of a nanosecond.
app::Trial invented(const app::PaperTable& paper, const std::vector<double>& clip)
{
    app::Trial trial{paper, {}};
    trial.record.options.lines = paper.lines;
    for (std::size_t i = 0; i < clip.size(); ++i) {
        app::Timing timing{.variant = {paper.columns[i].algorithm, Form::Published},
                           .generate = {},
                           .clip = {},
                           .draw = {}};
        for (int run = 0; run < 10; ++run) {
            timing.clip.push_back(clip[i] + 0.01 * run);
            timing.generate.push_back(20);
            timing.draw.push_back(5);
        }
        timing.found.visible = 40'000;
        trial.record.timings.push_back(std::move(timing));
    }
    return trial;
}

/// The median of each column of the paper, so that its ranking is the paper's.
std::vector<double> likeThePaper(const app::PaperTable& paper)
{
    std::vector<double> times;
    for (const auto& column : paper.columns)
        times.push_back(20 * app::summaryOf(column.runs).median);
    return times;
}

std::span<const app::Measure> clipOnly()
{
    static const auto all = app::measures();
    return std::span(all).first(1);
}

} // namespace

class StudyTest : public QObject {
    Q_OBJECT

private slots:
    void thePaperIsTheFirstSubjectAndEverySceneIsOne()
    {
        const auto all = app::subjects();
        QCOMPARE(all.front().papers.size(), 2u);
        QCOMPARE(all.size(), 3 + app::testScenes().size());
        std::set<QString> keys;
        for (const auto& one : all) {
            keys.insert(one.key);
            QVERIFY(!one.name.isEmpty() && one.meaning.endsWith('.'));
        }
        QCOMPARE(keys.size(), all.size());
    }

    void withoutFurtherWordsThePaperIsRepeated()
    {
        app::Choice choice{.subject = app::subjects().front()};
        choice.target = app::rasterTarget;
        const auto plan = app::planOf(choice);
        QVERIFY(plan);
        QCOMPARE(plan.value->trials.size(), 2u);
        QCOMPARE(plan.value->trials[0].options.lines, 1'000'000u);
        QCOMPARE(plan.value->trials[1].options.lines, 10'000'000u);
        for (const auto& trial : plan.value->trials) {
            QCOMPARE(trial.options.runs, 10u);
            QCOMPARE(trial.variants.size(), 7u);
            QVERIFY(std::ranges::all_of(
                trial.variants, [](const auto& one) { return one.form == Form::Published; }));
        }
        QCOMPARE(plan.value->measures.size(), 3u);
        QVERIFY(plan.value->explained);
        QVERIFY(plan.value->explained->options.lines <= 1'000'000);
    }

    void whereNothingIsVisibleNoTimeOfDrawingIsTold()
    {
        auto choice = few("near-miss");
        choice.target = app::rasterTarget;
        choice.forms = {Form::Corrected};
        choice.explained = false;
        const auto study = app::study(*app::planOf(choice).value);
        QCOMPARE(study->measures.size(), 2u);
        QCOMPARE(study->measures[0].key, "clip");
        QCOMPARE(study->measures[1].key, "total");
        QVERIFY(study->trials[0].record.target.startsWith("raster"));
    }

    void drawTargetIsAskedForItsNameOnce()
    {
        app::ExperimentOptions options;
        options.lines = 100;
        options.runs = 1;
        int made = 0;
        options.target = [&](const app::Field& field) {
            ++made;
            return app::rasterTarget(field);
        };
        const auto record =
            app::recorded(options, app::variantsOf({{clipping::findAlgorithm("md")}}));
        QVERIFY(record->target.startsWith("raster"));
        QCOMPARE(made, 1);
    }

    void withoutADrawTargetNothingIsSaidOfDrawing()
    {
        const auto plan = app::planOf(few("near-miss"));
        QCOMPARE(plan.value->measures.size(), 1u);
        QCOMPARE(plan.value->measures[0].key, "clip");
    }

    void impossibleChoicesAreRefusedWithASentence()
    {
        app::Choice choice = few("paper");
        choice.algorithms = {};
        QVERIFY(app::planOf(choice).error.contains("at least one algorithm"));
        choice.algorithms = named({"ex"});
        QVERIFY(app::planOf(choice).error.contains("published"));
        choice.forms = {Form::Corrected};
        QVERIFY(app::planOf(choice));
        for (const std::uint64_t lines : {std::uint64_t(0), app::mostLines + 1}) {
            choice.lines = lines;
            QVERIFY(!app::planOf(choice));
        }
        choice.lines = app::mostLines;
        QVERIFY(app::planOf(choice));
        choice.runs = 0;
        QVERIFY(!app::planOf(choice));
    }

    void aQuickChoiceIsSmall()
    {
        const auto plan = app::planOf(app::quick({.subject = app::subjects().front()}));
        for (const auto& trial : plan.value->trials) {
            QCOMPARE(trial.options.lines, 30'000u);
            QCOMPARE(trial.options.runs, app::usualRounds(trial.variants.size()));
        }
        QVERIFY(app::roughSeconds(*plan.value) < 10);
        QVERIFY(app::effortText(*plan.value).contains("4,200,000"));
    }

    void drawingIsExpectedToTakeItsTime()
    {
        app::Choice choice{.subject = app::subjects().front()};
        const double clipping = app::roughSeconds(*app::planOf(choice).value);
        choice.target = app::rasterTarget;
        QVERIFY(app::roughSeconds(*app::planOf(choice).value) > 2 * clipping);
        choice.algorithms = {&clipping::algorithms().front()};
        for (const auto& one : app::subjects()) {
            choice.subject = one;
            choice.target = app::rasterTarget;
            const double with = app::roughSeconds(*app::planOf(choice).value);
            choice.target = nullptr;
            QVERIFY(with >= app::roughSeconds(*app::planOf(choice).value));
        }
    }

    void theSpeedOfThisMachineCounts()
    {
        const auto plan = app::planOf({.subject = app::subjects().front()});
        QVERIFY(app::effortText(*plan.value, 1) != app::effortText(*plan.value, 7));
        QVERIFY(app::quickEffortText({.subject = app::subjects().front()}, 1)
                    .startsWith("Quick run: about "));
    }

    void manyThatAreLeftOutAreNotAllNamed()
    {
        app::Choice choice = few("paper");
        choice.algorithms.clear();
        for (const auto& algorithm : clipping::algorithms())
            if (!clipping::functionsOf(algorithm, clipping::Form::Published))
                choice.algorithms.push_back(&algorithm);
        if (choice.algorithms.size() > 7)
            QVERIFY(app::leftOutText(choice).endsWith(
                QString("and %1 others.").arg(choice.algorithms.size() - 3)));
    }

    void slowAlgorithmsGetLongerEstimates()
    {
        app::Choice choice = few("crossing");
        choice.lines = 1'000'000;
        const double usual = app::roughSeconds(*app::planOf(choice).value);
        choice.algorithms.push_back(clipping::findAlgorithm("ms")); // by halving
        QVERIFY(app::roughSeconds(*app::planOf(choice).value) > 3 * usual);
    }

    void aDrawingIsASubjectWithItsLinesAndWindow()
    {
        app::EditedDocument empty;
        QVERIFY(!app::drawingSubject("empty", app::Scene(empty).lines(), empty.now()));
        app::Sheet sheet;
        sheet.page.size = {100, 80};
        sheet.window = {{10, 10}, {50, 50}};
        app::Shape shape;
        shape.paths.push_back({{0, 20}, {{{90, 20}}, {{90, 70}}}, false});
        sheet.shapes.push_back(shape);
        const app::EditedDocument document(app::documentOf(sheet));
        const auto two = app::drawingSubject("two", app::Scene(document).lines(), document.now());
        QVERIFY(two);
        QCOMPARE(two->options.lines, 2u);
        app::Choice choice{.subject = *two};
        choice.runs = 2;
        choice.algorithms = named({"ex", "cs"});
        choice.forms = {Form::Corrected};
        const auto study = app::study(*app::planOf(choice).value);
        for (const auto& timing : study->trials[0].record.timings)
            QCOMPARE(timing.found.visible, 1u);
    }

    void withoutAWindowItIsClippedAtItsPage()
    {
        app::Sheet sheet;
        sheet.shapes.emplace_back();
        sheet.shapes.back().paths = {{{0, 20}, {{{90, 20}}}, false}};
        app::Document document = app::documentOf(sheet);
        document.apply({.windows = app::ClipWindows()});
        const app::EditedDocument edited(document);
        const auto subject = app::drawingSubject("it", app::Scene(edited).lines(), document);
        QVERIFY(subject);
        QCOMPARE(subject->options.field.window, document.page().rectangle());
        QVERIFY(subject->meaning.contains("at its page, because it has no clip window"));
    }

    void aRotatedWindowIsMeasuredAsSuch()
    {
        app::Sheet sheet;
        sheet.shapes.emplace_back();
        sheet.shapes.back().paths = {{{0, 20}, {{{90, 20}}}, false}};
        app::Document document = app::documentOf(sheet);
        const app::RectangleShape rotated{{{10, 10}, {30, 30}}, 0.5};
        document.apply({.windows = app::ClipWindows{{{.shape = rotated}}}});
        const app::EditedDocument edited(document);
        const auto subject = app::drawingSubject("it", app::Scene(edited).lines(), document);
        QVERIFY(subject && subject->options.field.shape);
        QVERIFY(subject->meaning.contains("at its window: rotated rectangle"));
        app::Choice choice{*subject};
        choice.runs = 2;
        choice.algorithms = named({"ex", "cs", "lb"});
        choice.forms = {Form::Corrected};
        const auto plan = app::planOf(choice);
        QVERIFY(plan && !plan.value->explained);
        const auto study = app::study(*plan.value);
        QCOMPARE(study->trials[0].record.timings.size(), 3u);
        for (const auto& timing : study->trials[0].record.timings)
            QCOMPARE(timing.found.visible, 1u);
        QVERIFY(subject->options.field.shape->text.startsWith("10,10,30,30@-28.6"));
        choice.order = app::Order::ByClass;
        QVERIFY(!app::planOf(choice));
    }

    void aStudyHasWhatWasPlanned()
    {
        app::Choice choice = few("all");
        choice.forms = {Form::Published, Form::Corrected};
        choice.target = app::rasterTarget;
        std::vector<double> shares;
        const auto study =
            app::study(*app::planOf(choice).value, {{}, [&](const app::Progress& now) {
                                                        shares.push_back(now.share);
                                                        QVERIFY(now.secondsLeft >= 0);
                                                    }});
        QVERIFY(study);
        QVERIFY(std::ranges::is_sorted(shares));
        QVERIFY(shares.front() > 0 && std::abs(shares.back() - 1) < 1e-9);
        QCOMPARE(study->trials.size(), 4u);
        QCOMPARE(app::nameOf(study->trials[1]), "Table 1, corrected");
        auto other = study->trials[1];
        other.record.options.scene = *app::findTestScene(u"long");
        QCOMPARE(app::nameOf(other), "Table 1, corrected, with lines of the scene “Long”");
        QVERIFY(app::verdict(other, clipOnly()).front().contains("other lines"));
        std::set<QString> keys;
        for (const auto& table : app::tablesOf(*study)) {
            QVERIFY2(keys.insert(table.key).second, qPrintable(table.key + " is there twice"));
            for (const auto& row : table.rows)
                QCOMPARE(row.size(), table.names.size());
        }
        for (const char* key :
             {"table1-paper", "table2-total-corrected", "table1-clip-published-against-paper",
              "classes", "operations", "accuracy"})
            QVERIFY2(keys.contains(key), key);
        // What is the same for all is a circumstance; what differs is none.
        const auto facts = app::circumstancesTable(*study).rows;
        const auto has = [&](const char* name) {
            return std::ranges::any_of(facts, [&](const auto& row) { return row[0] == name; });
        };
        QVERIFY(has("seed") && has("compiler") && has("drawn"));
    }

    void everyColumnHasAHeading()
    {
        app::Choice choice = few("long");
        const auto study = app::study(*app::planOf(choice).value);
        for (const auto& table : app::tablesOf(*study))
            for (const auto& name : table.names)
                QVERIFY2(app::headingOf(name).text != name, qPrintable(name));
        QCOMPARE(app::headingOf("KWC").text, "KWC");
    }

    void itStopsAfterTheTurnInHand_data()
    {
        QTest::addColumn<QString>("subject");
        QTest::addColumn<int>("after"); // milliseconds
        QTest::addColumn<int>("reported");
        for (const QString key : {"table2", "inside", "near-miss"}) {
            for (const int after : {0, 150, 600})
                QTest::addRow("%s after %d ms", qPrintable(key), after) << key << after << 0;
            QTest::addRow("%s after 3 turns", qPrintable(key)) << key << 0 << 3;
        }
    }
    // A turn of one variant is some hundredths of a second; each is reported.
    void itStopsAfterTheTurnInHand()
    {
        QFETCH(QString, subject);
        QFETCH(int, after);
        QFETCH(int, reported);
        app::Choice choice = few(subject);
        choice.lines = reported > 0 ? 1'000'000 : 10'000'000;
        choice.target = app::rasterTarget;
        choice.order = app::Order::ByClass;
        const auto plan = app::planOf(choice);
        bool nothing = false;
        std::atomic<int> turns{0};
        std::jthread thread([&](const std::stop_token& stop) {
            nothing = !app::study(*plan.value, {stop, [&](const app::Progress&) { ++turns; }});
        });
        QTest::qSleep(after);
        QTRY_VERIFY_WITH_TIMEOUT(turns >= reported, 200'000);
        const int before = turns;
        QElapsedTimer timer;
        timer.start();
        thread.request_stop();
        thread.join();
        qInfo("stopped after %d turns, %lld ms later", before, timer.elapsed());
        QVERIFY(nothing);
        // The turn in hand, and one that ended between the count and the stop.
        QVERIFY2(turns - before <= 2, qPrintable(QString::number(turns - before)));
    }

    void phasesAreOneProgress()
    {
        std::vector<app::Progress> seen;
        app::PhasedProgress phases({{}, [&](const app::Progress& now) { seen.push_back(now); }},
                                   {1, 3});
        const auto first = phases.next(), second = phases.next();
        first.progress({0.5, 2});
        second.progress({0, 9});
        second.progress({1, 0});
        QCOMPARE(seen[0].share, 0.125);
        QVERIFY(seen[0].secondsLeft >= 2);
        QCOMPARE(seen[1].share, 0.25);
        QCOMPARE(seen[2].share, 1.0);
        QCOMPARE(seen[2].secondsLeft, 0.0);
    }

    void thePapersOwnTimesKeepItsRanking()
    {
        const auto paper = app::paperTables()[1];
        const auto trial = invented(paper, likeThePaper(paper));
        const auto check = app::rankingCheck(paper, trial.record, app::measures().front());
        QCOMPARE(check.reversed, 0u);
        QCOMPARE(check.same + check.undecided, 21u);
        QVERIFY(check.same >= 18); // its averages and its medians hardly differ
        const auto told = app::verdict(trial, clipOnly()).join('\n');
        QVERIFY2(told.contains("Matthes-Drakopoulos (MD) is the fastest"), qPrintable(told));
        QVERIFY2(told.contains(check.undecided > 0 ? "Nothing contradicts" : "ranking holds"),
                 qPrintable(told));
        QVERIFY2(told.contains("the same 40,000 visible lines"), qPrintable(told));
        QVERIFY2(told.contains("the fastest algorithm in the paper's own runs is MD, if they are "
                               "paired row by row"),
                 qPrintable(told));
    }

    void reversedRankingIsReported()
    {
        const auto paper = app::paperTables()[1];
        auto times = likeThePaper(paper);
        for (double& time : times)
            time = 300 - time;
        auto trial = invented(paper, times);
        trial.record.timings[5].found = {.visible = 39'000, .lost = 1000};
        trial.record.circumstances = {
            {"processor", "A 9, 2 cores"}, {"memory", "1 KiB"}, {"compiler", "GCC 1"}};
        const auto check = app::rankingCheck(paper, trial.record, app::measures().front());
        QVERIFY(check.reversed >= 18);
        const auto told = app::verdict(trial, app::measures()).join('\n');
        QVERIFY2(told.contains("does not hold"), qPrintable(told));
        QVERIFY2(told.contains("KWC as published loses 1,000 of the 40,000"), qPrintable(told));
        QVERIFY2(!told.contains("but it loses lines"), qPrintable(told)); // it is not the fastest
        QCOMPARE(told.count("ranking does not hold here (A 9, 2 cores; GCC 1): "), 2);
    }

    void fastestThatLosesLinesIsReported()
    {
        const auto paper = app::paperTables()[0];
        auto trial = invented(paper, {30, 30, 30, 30, 30, 10, 30});
        trial.record.timings[5].found = {.visible = 39'000, .lost = 1000};
        const auto told = app::verdict(trial, clipOnly())[0];
        QVERIFY2(told.contains("is the fastest with") && told.contains("but it loses lines"),
                 qPrintable(told));
    }

    void equalTimesHaveNoFastest()
    {
        const auto paper = app::paperTables()[0];
        auto trial = invented(paper, {30, 10, 30, 30, 30, 30, 10.05});
        const auto told = app::verdict(trial, clipOnly())[0];
        QVERIFY2(told.contains("LB has the lowest median, 10.0") || told.contains("(LB) has the"),
                 qPrintable(told));
        QVERIFY2(told.contains("MD (1.005 times as long, p = 0.041) is practically equal"),
                 qPrintable(told));
        QVERIFY2(!told.contains("is the fastest"), qPrintable(told));
        // As far apart, but one time this one is faster and one time the other.
        for (std::size_t r = 0; r < 10; ++r)
            trial.record.timings[6].clip[r] = 10 + (r % 2 == 0 ? 1 : -0.9);
        const auto open = app::verdict(trial, clipOnly())[0];
        QVERIFY2(open.contains("times as long, p = ")
                     && open.contains("does not differ significantly from it."),
                 qPrintable(open));
        trial = invented(paper, std::vector<double>(7, 30.0));
        QVERIFY(app::verdict(trial, clipOnly())[0].contains("no significant difference"));
        QCOMPARE(app::rankingCheck(paper, trial.record, clipOnly()[0]).undecided, 21u);
    }

    void tooFewRunsTellNoFastest()
    {
        const auto paper = app::paperTables()[0];
        auto trial = invented(paper, {30, 10, 20, 40, 50, 60, 70});
        for (app::Timing& timing : trial.record.timings)
            timing.clip.resize(9);
        const auto told = app::verdict(trial, clipOnly())[0];
        QVERIFY2(
            told.contains("Too few runs: 7 algorithms need 10 runs, but this experiment has 9."),
            qPrintable(told));
        QVERIFY2(!told.contains("is the fastest") && told.contains("neither confirmed nor refuted"),
                 qPrintable(told));
        QCOMPARE(app::rankingCheck(paper, trial.record, clipOnly()[0]).undecided, 21u);
    }

    void exactIsTimedBothWays()
    {
        auto choice = few("paper");
        choice.algorithms = named({"exact", "md"});
        choice.forms = {Form::Corrected, Form::Published};
        choice.runs.reset();
        const auto plan = app::planOf(choice);
        QCOMPARE(plan.value->trials[0].variants.size(), 3u + 1u); // MD has two forms
        const auto study = app::study(*plan.value);
        const auto& timings = study->trials[0].record.timings;
        const auto is = [](const char* key) {
            return [=](const app::Timing& timing) { return timing.variant.algorithm->key == key; };
        };
        const auto batch = std::ranges::find_if(timings, is("exact")),
                   each = std::ranges::find_if(timings, is("exact-one-by-one"));
        QVERIFY(batch != timings.end() && each == batch + 1);
        QVERIFY(batch->found == each->found); // one algorithm
        const QString told = app::verdict(study->trials[0], clipOnly()).join(' ');
        QVERIFY2(told.contains("timed in batches") && told.contains("Called line by line"),
                 qPrintable(told));
        const auto table = app::timesTable(study->trials[0].record, clipOnly()[0]);
        QVERIFY(table.notes.join(' ').contains("timed in batches"));
        // What does not depend on how it is called is not told twice.
        QCOMPARE(study->explanation->classes.classes[0].record.timings.size(), 4u);
        QCOMPARE(study->explanation->operations.rows.size(), 3u);
        QCOMPARE(study->explanation->accuracies.size(), 3u);
        choice.algorithms = named({"md"});
        const auto without = app::study(*app::planOf(choice).value);
        QVERIFY(!app::verdict(without->trials[0], clipOnly()).join(' ').contains("batches"));
    }

    void theReasonIsTheCommonestClass()
    {
        const auto study = app::study(*app::planOf(few("rejected")).value);
        const auto told = app::reasons(*study->explanation);
        QCOMPARE(told.size(), qsizetype(app::tablesOf(*study->explanation).size()));
        QVERIFY2(told[0].startsWith("Most lines, 100 %, are of the class “rejected at once”."),
                 qPrintable(told[0]));
        QVERIFY2(told[1].contains("fewest operations"), qPrintable(told[1]));
        QVERIFY2(told[2].startsWith("All algorithms find the same lines"), qPrintable(told[2]));
    }

    void algorithmsThatLoseLinesAreNamed()
    {
        app::Choice choice = few("paper");
        choice.lines = 20'000;
        const auto told = app::reasons(*app::study(*app::planOf(choice).value)->explanation)[2];
        QVERIFY2(told.startsWith("KWC as published drops"), qPrintable(told));
    }
};

} // namespace experiment_study_test

TEST_CLASS(experiment_study_test::StudyTest, Gui)
#include "tests/app/experiment/study_test.moc"

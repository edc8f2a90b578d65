// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/choice.h"
#include "app/report/process_runs.h"
#include "app/report/repeat.h"

#include <QTest>

#include <algorithm>
#include <thread>

#include "tests/test_class.h"
#include "tests/verify.h"

namespace report_process_runs_test {

using namespace app;

namespace {

Choice choiceOf(const QString& key)
{
    const auto all = subjects();
    Choice choice{.subject = *std::ranges::find(all, key, &Subject::key)};
    choice.lines = 1000;
    choice.runs = 3;
    choice.seed = 7;
    choice.explained = false;
    choice.inProcesses = true;
    choice.algorithms = {clipping::findAlgorithm("CS"), clipping::findAlgorithm("exact")};
    choice.forms = {clipping::Form::Published, clipping::Form::Corrected}; // not bench's order
    return choice;
}

/// A window of coordinates that are no short decimals, and lines of which one is a point.
Choice drawingChoice()
{
    std::vector<clipping::Segment> lines;
    for (int i = 0; i < 50; ++i)
        lines.push_back({{i / 3.0, -i / 7.0}, {100 - i * 1.1, 1e-3 * i * i}});
    lines.push_back({{1 / 3.0, 0}, {1 / 3.0, 0}});
    Choice choice = choiceOf("paper");
    choice.subject.options.scene = repeatedScene("a drawing.svg", std::move(lines));
    choice.subject.options.field = {{{-10, -10}, {110, 110}}, {{1 / 3.0, -2}, {50, 0.7}}};
    return choice;
}

Study inOneProcess(Plan plan) { return *study(plan); }

} // namespace

class ProcessRunsTest : public QObject {
    Q_OBJECT

private slots:
    void theSameIsMeasuredAsInOneProcess_data()
    {
        QTest::addColumn<QString>("key");
        for (const char* key : {"paper", "near-miss", "table1", "all", "a drawing"})
            QTest::newRow(key) << key;
    }
    void theSameIsMeasuredAsInOneProcess()
    {
        QFETCH(QString, key);
        const Plan plan = *planOf(key == "a drawing" ? drawingChoice() : choiceOf(key)).value;
        const auto apart = studyInProcesses(plan, CLEARCUT_BINARY);
        VERIFY_OR_SAY(apart, apart.error.toUtf8());
        const Study together = inOneProcess(plan);
        QCOMPARE(apart.value->trials.size(), together.trials.size());
        for (std::size_t i = 0; i < together.trials.size(); ++i) {
            const Record &one = apart.value->trials[i].record, &other = together.trials[i].record;
            QVERIFY(one.options.inProcesses);
            QCOMPARE(one.timings.size(), other.timings.size());
            for (std::size_t k = 0; k < one.timings.size(); ++k) {
                const Timing &a = one.timings[k], &b = other.timings[k];
                QVERIFY(a.variant == b.variant);
                QCOMPARE(a.visible, b.visible);
                QCOMPARE(a.found.checksum, b.found.checksum);
                QCOMPARE(a.clip.size(), std::size_t(3));
                QVERIFY(std::ranges::all_of(a.clip, [](double t) { return t > 0; }));
            }
        }
    }

    /// The number of the first table's lines, of both tables.
    void theWordsSayTheLinesOfEveryTrial()
    {
        Choice choice = choiceOf("all");
        const auto wordsOf = [](const Choice& chosen) {
            const Plan plan = *planOf(chosen).value;
            Study study{measures(), {}};
            for (const PlannedTrial& trial : plan.trials) {
                Record record{trial.options, {}, {}, {}};
                for (const Variant& variant : trial.variants)
                    record.timings.push_back(
                        {.variant = variant, .generate = {}, .clip = {}, .draw = {}});
                study.trials.push_back({trial.paper, std::move(record)});
            }
            return wordsToRepeat(study);
        };
        choice.lines = 1'000'000;
        QVERIFY(wordsOf(choice).contains("--lines=1000000"));
        choice.lines.reset();
        QVERIFY(wordsOf(choice).filter("--lines").isEmpty());
    }

    void manyShortRunsAreStopped()
    {
        Choice choice = choiceOf("paper");
        choice.lines = 100;
        choice.runs = mostRuns; // of milliseconds
        std::stop_source stop;
        std::size_t turns = 0;
        const auto none = studyInProcesses(*planOf(choice).value, CLEARCUT_BINARY,
                                           {stop.get_token(), [&](const Progress&) {
                                                if (++turns == 3)
                                                    stop.request_stop();
                                            }});
        QVERIFY(!none && none.error.isEmpty());
        QCOMPARE(turns, std::size_t(3));
    }

    void aStoppedStudyIsNoError()
    {
        Choice choice = choiceOf("paper");
        choice.lines = 100'000'000; // minutes
        std::stop_source stop;
        const std::jthread soon([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            stop.request_stop();
        });
        const auto none =
            studyInProcesses(*planOf(choice).value, CLEARCUT_BINARY, {.stop = stop.get_token()});
        QVERIFY(!none);
        QCOMPARE(none.error, QString());
    }

    void aProgramThatFailsIsNamed()
    {
        const Plan plan = *planOf(choiceOf("paper")).value;
        for (const char* program : {"/bin/false", "/bin/true", "/nowhere/clearcut"}) {
            const auto none = studyInProcesses(plan, program);
            QVERIFY(!none);
            QVERIFY2(none.error.startsWith("The process of run 1 failed."), qPrintable(none.error));
        }
    }
};

} // namespace report_process_runs_test

TEST_CLASS(report_process_runs_test::ProcessRunsTest, Core)
#include "tests/app/report/process_runs_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/record.h"
#include "app/experiment/threads.h"

#include <QTest>

#include <algorithm>

#include "tests/test_class.h"

namespace experiment_block_test {

namespace {

using Single = clipping::BasicSegment<float>;

std::vector<const clipping::Algorithm*> everyAlgorithm()
{
    std::vector<const clipping::Algorithm*> algorithms;
    for (const auto& algorithm : clipping::algorithms())
        algorithms.push_back(&algorithm);
    return algorithms;
}

std::vector<clipping::Segment> paperLines(std::size_t count)
{
    std::vector<clipping::Segment> lines(count);
    app::PaperScene(7).fill(lines);
    return lines;
}

bool isSingle(const glm::dvec2& p) { return glm::dvec2(glm::vec2(p)) == p; }

} // namespace

class BlockTest : public QObject {
    Q_OBJECT

private slots:
    void singlePrecisionIsTheLibrarysOwn()
    {
        const clipping::Window window{{-100.1, -75}, {100, 75.3}};
        app::Block block({window, app::Precision::Single});
        const auto lines = paperLines(10'000);
        block.refill(lines.size(), [&](auto to) { std::ranges::copy(lines, to.begin()); });
        QVERIFY(isSingle(block.window().min) && isSingle(block.window().max));
        std::vector<Single> rounded;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            rounded.push_back({glm::vec2(lines[i].a), glm::vec2(lines[i].b)});
            QVERIFY(isSingle(block.lines()[i].a) && isSingle(block.lines()[i].b));
        }
        std::vector<clipping::BasicClipped<Single>> truth(lines.size());
        for (const app::Variant& one :
             app::variantsOf(everyAlgorithm(), clipping::Form::Corrected)) {
            const auto count = one.algorithm->floats->clipAll(
                rounded, {glm::vec2(window.min), glm::vec2(window.max)}, truth);
            const auto found = block.pieces(block.clip(one));
            QCOMPARE(found.size(), count);
            for (std::size_t i = 0; i < count; ++i) {
                QCOMPARE(found[i].source, truth[i].source);
                QCOMPARE(found[i].cut, truth[i].cut);
                QVERIFY(glm::vec2(found[i].segment.a) == truth[i].segment.a);
                QVERIFY(glm::vec2(found[i].segment.b) == truth[i].segment.b);
                QVERIFY(isSingle(found[i].segment.a) && isSingle(found[i].segment.b));
            }
        }
    }

    void severalThreadsFindTheSameLinesAsOne()
    {
        if (app::mostThreads() == 1)
            QSKIP("one core, or no oneTBB: nothing to share out");
        const auto lines = paperLines(300'001);
        for (const auto precision : {app::Precision::Double, app::Precision::Single})
            for (const app::Variant& one :
                 app::variantsOf(everyAlgorithm(), clipping::Form::Corrected)) {
                app::Block alone({app::paperWindow, precision}),
                    together({app::paperWindow, precision, app::mostThreads()});
                for (app::Block* block : {&alone, &together})
                    block->refill(lines.size(),
                                  [&](auto to) { std::ranges::copy(lines, to.begin()); });
                const auto expected = alone.pieces(alone.clip(one));
                const auto found = together.pieces(together.clip(one));
                QCOMPARE(found.size(), expected.size());
                QVERIFY(std::ranges::equal(found, expected, [](const auto& a, const auto& b) {
                    return a.segment == b.segment && a.source == b.source && a.cut == b.cut;
                }));
            }
    }

    void experimentsSayHowTheyClip()
    {
        app::ExperimentOptions options;
        options.lines = 20'000;
        options.runs = 1;
        options.precision = app::Precision::Single;
        const auto all = app::variantsOf(everyAlgorithm(), clipping::Form::Corrected);
        const auto record = app::recorded(options, all);
        for (const app::Timing& timing : record->timings) {
            QVERIFY(timing.found.visible > 3000);
            QVERIFY(timing.found.lost <= 1); // the truth is that of the rounded lines
            QVERIFY(timing.found.shown <= 1);
        }
        const auto facts = app::factsOf(*record);
        const auto has = [&](const QString& name, const QString& value) {
            return std::ranges::find(facts, std::pair(name, value)) != facts.end();
        };
        QVERIFY(has("precision", "single"));
        QVERIFY(has("threads", "1"));
        options.precision = app::Precision::Double;
        QVERIFY(app::recorded(options, all)->timings[0].found.checksum
                != record->timings[0].found.checksum);
    }

    void everyRunHasARow()
    {
        app::ExperimentOptions options;
        options.lines = 1000;
        options.runs = 4;
        const auto all = app::variantsOf({{clipping::findAlgorithm("cs")}});
        const auto record = *app::recorded(options, all);
        const app::Measure clip = app::measures().front();
        const app::Table table = app::runsTable(record, {&clip, 1});
        QCOMPARE(table.rows.size(), all.size() * options.runs);
        double sum = 0;
        for (std::size_t r = 0; r < options.runs; ++r) {
            const QStringList& row = table.rows[r];
            QCOMPARE(row.size(), table.names.size());
            QCOMPARE(row[table.names.indexOf("run")], QString::number(r + 1));
            sum += row[table.names.indexOf("seconds")].toDouble();
        }
        const double mean = app::summaries(record, clip)[0].mean; // nanoseconds a line
        QVERIFY(std::abs(sum / 4 * 1e9 / 1000 - mean) < 0.01);
    }
};

} // namespace experiment_block_test

TEST_CLASS(experiment_block_test::BlockTest, None)
#include "tests/app/experiment/block_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/axis.h"

#include <QTest>

#include <algorithm>

#include "tests/app/charts/sample_charts.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace charts_chart_test {

using namespace app;

namespace {

Chart boxesOf(std::initializer_list<std::vector<double>> numbers)
{
    Chart chart{.key = {}, .title = {}, .panels = {{{}, {}, false}}, .rows = {}};
    for (const auto& some : numbers)
        chart.rows.push_back({.name = {}, .figures = {boxOf(some)}});
    return chart;
}

const Bar& barOf(const ChartRow& row, std::size_t panel = 0)
{
    return std::get<Bar>(row.figures[panel]);
}

} // namespace

class ChartTest : public QObject {
    Q_OBJECT

private slots:
    void aBoxIsWhatTukeyDrew()
    {
        // By hand: quartiles 3 and 7, so whiskers reach from -3 to 13 at most.
        const Box box = boxOf(std::vector<double>{5, 1, 20, 2, 3, 7, 6, 4, 13});
        QCOMPARE(box.median, 5.0);
        QCOMPARE(box.quartiles.low, 3.0);
        QCOMPARE(box.quartiles.high, 7.0);
        QCOMPARE(box.whiskers.low, 1.0);
        QCOMPARE(box.whiskers.high, 13.0);
        QCOMPARE(box.outliers, std::vector<double>{20});
        const Box one = boxOf(std::vector<double>{4});
        QCOMPARE(one.median, 4.0);
        QCOMPARE(one.whiskers.high, 4.0);
    }
    void axesHaveRoundMarksAndShowEverything()
    {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> power(-4, 7);
        for (int i = 0; i < 2000; ++i) {
            const double low = std::pow(10, power(random)),
                         high = low + std::pow(10, power(random));
            const Axis axis = axisOf(boxesOf({{low, high}}), 0, 5);
            QVERIFY(axis.range.low <= low && high <= axis.range.high);
            QVERIFY(!axis.ticks.empty() && axis.ticks.size() <= 6);
            for (const double tick : axis.ticks) {
                QVERIFY(axis.range.low <= tick && tick <= axis.range.high);
                // what is printed is the mark
                const double printed = QString::number(tick, 'f', axis.decimals).toDouble();
                QVERIFY(std::abs(printed - tick) <= 1e-9 * high);
            }
        }
    }
    void barsStartAtZero()
    {
        Chart chart{.key = {}, .title = {}, .rows = {}};
        for (const double length : {95.0, 97.0, 99.0})
            chart.rows.push_back({.name = {}, .figures = {Bar{{length}}}});
        QCOMPARE(axisOf(chart, 0, 5).range.low, 0.0);
        QCOMPARE(axisOf(chart, 0, 5).ticks.front(), 0.0);
    }
    void emptyChartsHaveAnAxisToo()
    {
        const Chart chart{.key = {}, .title = {}, .rows = {}};
        QVERIFY(axisOf(chart, 0, 5).range.high > axisOf(chart, 0, 5).range.low);
    }
    void recordsBecomeRatios()
    {
        const Measure clip = measures().front();
        const Record record = sample::seven();
        const auto times = summaries(record, clip);
        const Chart chart = chartOf(record, clip, paperTables().front());
        const double fastest = std::ranges::min(times, {}, &Summary::median).median;
        for (std::size_t i = 0; i < times.size(); ++i) {
            const auto row =
                std::ranges::find(chart.rows, record.timings[i].variant, &ChartRow::variant);
            QVERIFY(std::abs(barOf(*row).length() - times[i].median / fastest) < 1e-12);
            QCOMPARE(row->numbers.size(), 2);
        }
        // the paper's Table 1 as it is printed: LB 1.256 s, the proposed one 1.165 s
        const auto lb = std::ranges::find(chart.rows, QString("LB"), &ChartRow::name);
        QCOMPARE(lb->numbers[1], QString::number(1.256 / 1.165, 'f', 2));
        QVERIFY(std::abs(*lb->other - 1.256 / 1.165) < 1e-12);
    }
    void oneRunHasNoConfidence()
    {
        Record record = sample::seven();
        for (Timing& timing : record.timings)
            timing.clip.resize(1);
        for (const ChartRow& row : notEmpty(chartOf(record, measures().front()).rows))
            QVERIFY(!barOf(row).whiskers);
    }
    void onlyTheCorrectedFormIsSetBesideThePaper()
    {
        const Chart chart =
            chartOf(sample::everything(), measures().front(), paperTables().front());
        QCOMPARE(std::ranges::count_if(chart.rows,
                                       [](const ChartRow& row) { return row.other.has_value(); }),
                 7);
        for (const ChartRow& row : chart.rows)
            QVERIFY(!row.other || row.variant.form == clipping::Form::Corrected);
    }
    void thePapersFastestIsOneOnBothScales()
    {
        const sample::Times all[]{
            {"EX", sample::ours, 2}, {"CS", sample::ours, 20}, {"MD", sample::ours, 30}};
        const Record record = sample::record(all, 0.001);
        const Chart with = chartOf(record, measures().front(), paperTables().front()),
                    without = chartOf(record, measures().front());
        QCOMPARE(barOf(without.rows[0]).length(), 1.0);
        QCOMPARE(barOf(with.rows[1]).length(), 1.0);
        QVERIFY(std::abs(barOf(with.rows[0]).length() - 0.1) < 0.001);
        QVERIFY(with.title != without.title);
        QCOMPARE(*with.rows[2].other, 1.0); // MD in the paper
    }
    void aNoteOfAllRowsIsSaidOnce()
    {
        const sample::Times all[]{{"CS", sample::theirs, 20}, {"MD", sample::theirs, 30}};
        const Record record = sample::record(all, 0.001);
        for (const Chart& chart :
             {chartOf(record, measures().front()), boxPlotOf(record, measures().front())}) {
            QVERIFY(chart.subtitle.contains("as published"));
            for (const ChartRow& row : chart.rows)
                QVERIFY(row.note.isEmpty());
        }
        const Chart mixed = chartOf(sample::everything(), measures().front());
        QVERIFY(!mixed.subtitle.contains("as published"));
        QVERIFY(std::ranges::any_of(
            mixed.rows, [](const ChartRow& row) { return row.note == "as published"; }));
    }
    void operationsAddUp()
    {
        const OperationProfile profile = sample::operations();
        const Chart chart = chartOf(profile);
        QCOMPARE(chart.legend.size(), std::size_t(4));
        const auto table = operationTable(profile);
        for (const VariantOperations& one : profile.rows) {
            const auto row = std::ranges::find(chart.rows, one.variant, &ChartRow::variant);
            const auto counts = one.scene();
            QCOMPARE(barOf(*row).parts, (std::vector{double(counts.comparisons) / 2000,
                                                     double(counts.additions) / 2000,
                                                     double(counts.multiplications) / 2000,
                                                     double(counts.divisions) / 2000}));
            // The table says the same of the whole scene.
            QVERIFY(std::ranges::any_of(table.rows, [&](const QStringList& fields) {
                return fields[0].toStdString() == one.variant.algorithm->key
                       && fields[1] == wordOf(one.variant.form) && fields[2] == "whole scene"
                       && std::abs(fields.back().toDouble() - barOf(*row).length()) < 0.006;
            }));
        }
    }
    void classesArePanels()
    {
        const Chart chart = chartOf(sample::classes());
        QCOMPARE(chart.panels.size(), lineClasses.size());
        for (const ChartRow& row : chart.rows)
            for (std::size_t p = 1; p < chart.panels.size(); ++p)
                QVERIFY(barOf(row, p).length() > barOf(row, p - 1).length());
    }
    void aClassWithoutLinesHasNoBars()
    {
        ClassProfile profile = sample::classes();
        profile.classes[0].record.timings.clear();
        for (const ChartRow& row : notEmpty(chartOf(profile).rows)) {
            QVERIFY(std::holds_alternative<std::monostate>(row.figures[0]));
            QVERIFY(std::holds_alternative<Bar>(row.figures[1]));
        }
    }
    void wordsSayWhatThePictureShows()
    {
        const QString words = textOf(chartOf(sample::seven(), measures().front()));
        for (const char* part : {"lowest median = 1", "Cohen-Sutherland", "Matthes-Drakopoulos",
                                 "Bracket d: MD, LB do not differ significantly"})
            QVERIFY2(words.contains(part), part);
    }
};

} // namespace charts_chart_test

TEST_CLASS(charts_chart_test::ChartTest, Gui)
#include "tests/app/charts/chart_test.moc"

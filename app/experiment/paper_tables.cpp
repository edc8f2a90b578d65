// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/paper_tables.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/experiment/paper_scene.h"
#include "app/experiment/ranking_text.h"
#include "app/formats/coordinates.h"

#include <algorithm>
#include <cassert>

namespace app {
namespace {

/// A table's columns in seconds per run, measured by the paper or by us.
using Columns = std::vector<std::vector<double>>;

Columns secondsOf(const Record& record, const Measure& measure)
{
    Columns columns;
    for (const Timing& timing : record.timings) {
        columns.push_back(measure.times(timing));
        for (double& time : columns.back())
            time *= double(record.options.lines) * 1e-9;
    }
    return columns;
}

Columns secondsOf(const PaperTable& paper)
{
    Columns columns;
    for (const PaperColumn& column : paper.columns)
        columns.push_back(column.runs);
    return columns;
}

std::vector<Summary> summariesOf(const Columns& columns)
{
    std::vector<Summary> all;
    for (const auto& column : columns)
        all.push_back(summaryOf(column));
    return all;
}

QStringList namesOf(const PaperTable& paper)
{
    QStringList names;
    for (const PaperColumn& column : paper.columns)
        names << column.name;
    return names;
}

/// The paper's three decimals, or as many as three digits of the shortest time need.
int decimalsFor(std::span<const Summary> summaries)
{
    const auto shortest = std::ranges::min(summaries, {}, &Summary::mean).mean;
    return shortest >= 0.1 ? 3 : shortest >= 0.01 ? 4 : 6;
}

Table layout(const PaperTable& paper, const Columns& columns)
{
    const auto summaries = summariesOf(columns);
    const int decimals = decimalsFor(summaries);
    Table table{.names = QStringList(Text::tr("Exec.")) + namesOf(paper), .key = paper.key};
    for (std::size_t r = 0; r < columns[0].size(); ++r) {
        QStringList row(QString::number(r + 1));
        for (const auto& column : columns)
            row << QString::number(column[r], 'f', decimals);
        table.rows.push_back(row);
    }
    QStringList averages(Text::tr("Avg:"));
    for (const Summary& summary : summaries)
        averages << QString::number(summary.mean, 'f', decimals);
    table.rows.push_back(averages);
    table.notes << rankingText(table.names.sliced(1), rankingOf(columns));
    return table;
}

/// "2,000 lines", "2,000 lines of the scene “Long”".
QString linesText(const ExperimentOptions& options)
{
    const QString count = countText(options.lines), other = otherLinesText(options);
    return other.isEmpty() ? Text::tr("%1 lines").arg(count) : count + u' ' + other;
}

QString titleOf(const PaperTable& paper, const Record& record, const Measure& measure)
{
    return Text::tr("%1, %2: seconds for %3, algorithms %4")
        .arg(numberOf(paper), measure.name, linesText(record.options),
             wordOf(record.timings.front().variant.form));
}

/// The lines that a published form loses, if any.
QStringList lossesOf(const PaperTable& paper, const Record& record)
{
    QStringList sentences;
    for (std::size_t i = 0; i < record.timings.size(); ++i)
        if (const Findings& found = record.timings[i].found; found.lost + found.shown > 0)
            sentences << Text::tr(
                             "%1 loses %2 of the %3 visible lines and shows invisible lines: %4.")
                             .arg(paper.columns[i].name, countText(found.lost),
                                  countText(found.visible + found.lost - found.shown),
                                  countText(found.shown));
    return sentences;
}

QString perCent(double number) { return QString::number(number, 'f', 2); }

} // namespace

QString numberOf(const PaperTable& paper) { return Text::tr("Table %1").arg(paper.key.back()); }

QString otherLinesText(const ExperimentOptions& options)
{
    if (options.scene.key != testScenes().front().key)
        return Text::tr("lines of the scene “%1”").arg(options.scene.name);
    const bool same = rectangleText(options.field.space) == rectangleText(paperSpace)
                      && windowText(options.field) == rectangleText(paperWindow);
    return same ? QString() : Text::tr("lines in another space or window");
}

QString otherWorkText(const PaperTable& paper, const ExperimentOptions& options,
                      const Measure& measure)
{
    if (measure.key == u"total" && options.lines == paper.lines
        && otherLinesText(options).isEmpty())
        return {};
    return Text::tr(
               "The work differs: the paper timed generating, clipping and drawing %1 random lines "
               "together; our times are “%2” of %3. Compare ranks and ratios, not seconds.")
        .arg(countText(paper.lines), measure.name, linesText(options));
}

std::vector<Variant> variantsOf(const PaperTable& paper, clipping::Form form)
{
    std::vector<Variant> all;
    for (const PaperColumn& column : paper.columns)
        all.push_back({column.algorithm, form});
    return all;
}

Table paperLayout(const PaperTable& paper, const Record& record, const Measure& measure)
{
    assert(record.timings.size() == paper.columns.size());
    Table table = layout(paper, secondsOf(record, measure));
    table.key = QStringLiteral("%1-%2-%3")
                    .arg(paper.key, measure.key, wordOf(record.timings.front().variant.form));
    table.title = titleOf(paper, record, measure);
    table.facts = factsOf(record);
    table.notes = QStringList(measure.meaning) + table.notes + lossesOf(paper, record);
    return table;
}

Table paperLayout(const PaperTable& paper)
{
    Table table = layout(paper, secondsOf(paper));
    for (std::size_t c = 0; c < paper.columns.size(); ++c)
        table.rows.back()[qsizetype(c) + 1] =
            QString::number(paper.columns[c].printedAverage, 'f', 3);
    table.key = paper.key + QStringLiteral("-paper");
    table.title = Text::tr("%1 of the paper itself: seconds for %2 lines")
                      .arg(numberOf(paper), countText(paper.lines));
    table.notes << paperPairingText();
    return table;
}

Table againstPaper(const PaperTable& paper, const Record& record, const Measure& measure)
{
    const auto ours = summariesOf(secondsOf(record, measure));
    const Ranking theirRanking = rankingOf(paper), ourRanking = rankingOf(record, measure);
    Table table{
        .names = {"algorithm", "paper_s", "ours_s", "paper_rank", "our_rank", "paper_faster",
                  "our_faster", "paper_saves", "our_saves", "paper_letters", "our_letters"},
        .title = Text::tr("Against the paper: %1").arg(titleOf(paper, record, measure)),
        .key = QStringLiteral("%1-%2-%3-against-paper")
                   .arg(paper.key, measure.key, wordOf(record.timings.front().variant.form)),
        .facts = factsOf(record)};
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const PaperColumn& column = paper.columns[i];
        const double average = column.printedAverage;
        QStringList row{column.name, QString::number(average, 'f', 3),
                        QString::number(ours[i].mean, 'f', decimalsFor(ours)),
                        rankText(theirRanking, i), rankText(ourRanking, i)};
        for (const auto faster : {fasterByProposed, fasterByOther}) {
            const bool other = &column != &paper.columns.back();
            const double last = paper.columns.back().printedAverage;
            row << (other ? perCent(faster(average, last)) : QString())
                << (other ? perCent(faster(ours[i].mean, ours.back().mean)) : QString());
        }
        table.rows.push_back(row << lettersText(theirRanking, i) << lettersText(ourRanking, i));
    }
    if (const QString other = otherWorkText(paper, record.options, measure); !other.isEmpty())
        table.notes << other;
    table.notes << Text::tr(
        "Faster: the difference of the times of the other algorithm and Prop. in per cent of "
        "Prop.'s time, as in the paper. Saves: the same difference in per cent of the other's "
        "time. Both are computed from averages, the paper's as printed. Negative: Prop. is slower.")
                << Text::tr("The paper timed generating, clipping and drawing together: "
                            "compare its times with Total.")
                << rankingNotes(ourRanking) << paperPairingText();
    return table;
}

Ranking rankingOf(const PaperTable& paper) { return rankingOf(secondsOf(paper)); }

QString paperPairingText()
{
    return Text::tr(
        "The tests pair the paper's own runs row by row, as if the runs of one row were made in "
        "the same round. That is an assumption: the paper does not say so.");
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/study_report.h"

#include "app/base/numbers.h"
#include "app/base/short_names.h"
#include "app/base/text.h"
#include "app/charts/study_charts.h"
#include "app/experiment/one_by_one.h"
#include "app/experiment/verdict.h"
#include "app/report/repeat.h"

#include <algorithm>

namespace app {
namespace {

/// The tables without the facts that the table of circumstances has already.
std::vector<Table> withoutFacts(std::vector<Table> tables, const Table& circumstances)
{
    const auto told = [&](const std::pair<QString, QString>& fact) {
        return std::ranges::find(circumstances.rows, QStringList{fact.first, fact.second})
               != circumstances.rows.end();
    };
    for (Table& table : tables)
        std::erase_if(table.facts, told);
    return tables;
}

/// The meaning of each measure, one sentence each.
QStringList meaningsOf(const Study& study)
{
    QStringList all;
    for (const Measure& measure : study.measures)
        all << Text::tr("%1: %2").arg(measure.name, measure.meaning);
    return all;
}

QString introduction(const Study& study)
{
    QStringList names;
    for (const Trial& trial : study.trials)
        for (const Timing& timing : trial.record.timings)
            if (timing.variant.algorithm != &exactOneByOne())
                names << introducedName(*timing.variant.algorithm);
    names.removeDuplicates();
    return Text::
        tr("A line-clipping algorithm keeps the part of each line that lies inside a window. This "
           "report compares the following algorithms on the same lines; less time is better: %1.")
            .arg(names.join(QStringLiteral(", ")));
}

/// "Table 1, as published", "Scene “Near miss”".
QString titleOf(const Trial& trial)
{
    return trial.paper ? nameOf(trial) : Text::tr("Scene “%1”").arg(nameOf(trial));
}

/// The result of one trial, which the first words name.
QStringList summaryOf(const Trial& trial, const Study& study)
{
    QStringList sentences = verdict(trial, study.measures);
    if (!sentences.isEmpty())
        sentences.front() =
            Text::tr("%1, %2 lines. %3")
                .arg(titleOf(trial), countText(trial.record.options.lines), sentences.front());
    return sentences;
}

ReportSection sectionOf(const Trial& trial, const Study& study, const Table& circumstances)
{
    ReportSection section{.title = titleOf(trial), .sentences = meaningsOf(study)};
    for (const Measure& measure : study.measures) {
        std::ranges::move(chartsOf(trial, measure), std::back_inserter(section.charts));
        for (Table& table : withoutFacts(tablesOf(trial, measure, Against::Paper), circumstances))
            section.tables.push_back(std::move(table));
    }
    return section;
}

/// Each table of the paper, without repetition.
std::vector<PaperTable> papersOf(const Study& study)
{
    std::vector<PaperTable> papers;
    for (const Trial& trial : study.trials)
        if (trial.paper
            && std::ranges::find(papers, trial.paper->key, &PaperTable::key) == papers.end())
            papers.push_back(*trial.paper);
    return papers;
}

ReportSection paperSection(const std::vector<PaperTable>& papers)
{
    ReportSection section{
        .title = Text::tr("The paper's own numbers"),
        .sentences = {Text::tr("D. Matthes, V. Drakopoulos: Another Simple but Faster Method "
                               "for 2D Line Clipping, 2019. The runs are as printed; we "
                               "computed letters and medians from them."),
                      paperPairingText()}};
    for (const PaperTable& paper : papers) {
        section.charts.push_back(chartOf(paper));
        section.tables.push_back(paperLayout(paper));
    }
    return section;
}

ReportSection explanationSection(const Explanation& explanation, const Table& circumstances)
{
    return {.title = Text::tr("Reasons"),
            .sentences = reasons(explanation),
            .charts = chartsOf(explanation),
            .tables = withoutFacts(tablesOf(explanation), circumstances)};
}

/// From the first trial in which `exact` takes part.
QStringList batchSentences(const Study& study)
{
    for (const Trial& trial : study.trials)
        if (const QString text = batchText(variantsOf(trial.record)); !text.isEmpty())
            return {text};
    return {};
}

ReportSection methodSection(const Study& study, const Table& circumstances)
{
    return {
        .title = Text::tr("How it was measured"),
        .sentences =
            QStringList{
                Text::tr("Every algorithm clips the same lines. The algorithms take turns block "
                         "by block, and their order changes from block to block and from run to "
                         "run. So a moment when the machine is slow affects all algorithms."),
                Text::tr(
                    "Ranks are by median. Two algorithms are compared by the exact two-sided "
                    "Wilcoxon signed-rank test, paired by run. They differ if it finds a "
                    "difference at a level of 5 %, and the median of the ratios run by run differs "
                    "by 1 % or more. A smaller difference counts as practically equal."),
                Text::tr(
                    "All pairs of algorithms are tested, with Holm's correction for the number of "
                    "tests. These tests decide letters, ranks, and which algorithm is the fastest. "
                    "One that does not differ from another has no rank. Overlapping "
                    "confidence intervals do not show whether algorithms differ."),
                Text::tr("Nanoseconds depend on the machine. Compare ratios.")}
            + batchSentences(study),
        .tables = {circumstances}};
}

ReportSection repeatSection(const Study& study)
{
    return {.title = Text::tr("Repeat the measurement"),
            .sentences = {Text::tr(
                "The same seed gives the same lines on every machine. Each run has the "
                "next seed.")},
            .code = commandToRepeat(study)};
}

} // namespace

Report reportOf(const Study& study)
{
    const Table circumstances = circumstancesTable(study);
    Report report{.title = Text::tr("Line clipping: the time of each algorithm"), .sections = {}};
    report.summary << introduction(study);
    if (study.explanation)
        report.sections.push_back(explanationSection(*study.explanation, circumstances));
    for (const Trial& trial : study.trials) {
        report.summary << summaryOf(trial, study);
        report.sections.push_back(sectionOf(trial, study, circumstances));
    }
    if (const auto papers = papersOf(study); !papers.empty())
        report.sections.push_back(paperSection(papers));
    report.sections.push_back(methodSection(study, circumstances));
    report.sections.push_back(repeatSection(study));
    return report;
}

} // namespace app

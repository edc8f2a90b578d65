// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/verdict.h"

#include "app/experiment/contestant_name.h"
#include "app/experiment/paper_tables.h"
#include "app/latin.h"
#include "app/view/numbers.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {
namespace {

struct Experiments {
    Q_DECLARE_TR_FUNCTIONS(Experiments)
};

std::vector<Contestant> contestantsOf(const Record& record)
{
    std::vector<Contestant> all;
    for (const Timing& timing : record.timings)
        all.push_back(timing.contestant);
    return all;
}

QString shortName(const Record& record, std::size_t i)
{
    return nameAmong(contestantsOf(record), i);
}

/// "Nicholl-Lee-Nicholl (NLN)".
QString longName(const Record& record, std::size_t i)
{
    const QString name = latin(record.timings[i].contestant.algorithm->name);
    const QString brief = shortName(record, i);
    return brief.startsWith(name) ? brief : Experiments::tr("%1 (%2)").arg(name, brief);
}

QString timesText(double ratio) { return Experiments::tr("%1 times").arg(numberText(ratio, 2)); }

/// By median: the fastest, and those that are too close to call against it. They may differ among
/// themselves.
std::vector<std::size_t> leaders(const std::vector<Summary>& times)
{
    std::vector<std::size_t> first = sortedByMedian(times);
    const Interval fastest = times[first.front()].confidence;
    std::erase_if(first, [&](std::size_t i) { return !times[i].confidence.overlaps(fastest); });
    return first;
}

bool allTie(const std::vector<Summary>& times, const std::vector<std::size_t>& some)
{
    return std::ranges::all_of(some, [&](std::size_t i) {
        return std::ranges::all_of(
            some, [&](std::size_t j) { return times[i].confidence.overlaps(times[j].confidence); });
    });
}

/// Whoever leaves lines out has less to do: that must be said where it wins.
bool losesLines(const Record& record, std::size_t i) { return record.timings[i].found.lost > 0; }

/// "22.30 ns a line", "22.30 to 22.41 ns a line": the medians of some, sorted by them.
QString rangeText(const std::vector<Summary>& times, const std::vector<std::size_t>& some)
{
    const double low = times[some.front()].median, high = times[some.back()].median;
    const QString least = numberText(low, high < 100 ? 2 : 0), most = timeText(high);
    return most.startsWith(least + u' ') ? most : Experiments::tr("%1 to %2").arg(least, most);
}

/// "; CB, the slowest, takes 2.36 times as long": of who is slower beyond doubt.
QString slowestText(const Record& record, const std::vector<Summary>& times)
{
    const auto order = sortedByMedian(times);
    const Summary &fastest = times[order.front()], &slowest = times[order.back()];
    if (slowest.confidence.overlaps(fastest.confidence))
        return {};
    const bool alone =
        std::ranges::count_if(
            times, [&](const Summary& one) { return one.confidence.overlaps(slowest.confidence); })
        == 1;
    return (alone ? Experiments::tr("; %1, the slowest, takes %2 as long")
                  : Experiments::tr("; %1, the slowest by median, takes %2 as long"))
        .arg(shortName(record, order.back()), timesText(slowest.median / fastest.median));
}

QString leaderName(const Record& record, std::size_t i)
{
    return losesLines(record, i) ? Experiments::tr("%1 (loses lines)").arg(shortName(record, i))
                                 : shortName(record, i);
}

QString leaderSentence(const Record& record, const Measure& measure)
{
    const auto times = summaries(record, measure);
    const auto first = leaders(times);
    if (times.size() == 1)
        return Experiments::tr("%1: %2 takes %3.")
            .arg(measure.name, longName(record, 0), timeText(times[0].median));
    const QString slowest = slowestText(record, times);
    if (first.size() == 1)
        return (losesLines(record, first[0])
                    ? Experiments::tr("%1: %2 is the fastest with %3, but it loses lines%4.")
                    : Experiments::tr("%1: %2 is the fastest with %3%4."))
            .arg(measure.name, longName(record, first[0]), timeText(times[first[0]].median),
                 slowest);
    QStringList names;
    for (const std::size_t i : first)
        names << leaderName(record, i);
    if (!allTie(times, first))
        return Experiments::tr("%1: %2 has the lowest median, %3, but against it each of %4 is too "
                               "close to call, with %5%6.")
            .arg(measure.name, names.front(), timeText(times[first[0]].median),
                 briefListText(names.sliced(1)), rangeText(times, {first.begin() + 1, first.end()}),
                 slowest);
    if (first.size() == times.size())
        return Experiments::tr("%1: too close to call, all of them take %2.")
            .arg(measure.name, rangeText(times, first));
    return Experiments::tr("%1: %2 are the fastest with %3, too close to call%4.")
        .arg(measure.name, briefListText(names), rangeText(times, first), slowest);
}

QString proposedText(const Record& record, const Measure& measure)
{
    const auto times = summaries(record, measure);
    const auto first = leaders(times);
    const std::size_t proposed = times.size() - 1;
    const double fastest = std::ranges::min(times, {}, &Summary::median).median;
    if (std::ranges::find(first, proposed) == first.end())
        return Experiments::tr("its own method, %1, takes %2 as long as the fastest")
            .arg(longName(record, proposed), timesText(times[proposed].median / fastest));
    return first.size() == 1
               ? Experiments::tr("its own method, %1, is the fastest")
                     .arg(longName(record, proposed))
               : Experiments::tr("its own method, %1, is among the fastest, too close to call")
                     .arg(longName(record, proposed));
}

QString rankingSentence(const Trial& trial, const Measure& measure)
{
    const auto check = rankingCheck(*trial.paper, trial.record, measure);
    const QString own = proposedText(trial.record, measure);
    const QString pairs = countText(check.same + check.reversed + check.undecided),
                  undecided = countText(check.undecided);
    if (check.same + check.reversed == 0)
        return Experiments::tr("Nothing can be said of the paper's ranking: all %1 pairs are too "
                               "close to call.")
            .arg(pairs);
    if (check.reversed > 0)
        return Experiments::tr("The paper's ranking does not hold: %1, and %2 of %3 pairs come out "
                               "the other way round (%4 as in the paper, %5 are too close to "
                               "call).")
            .arg(own, countText(check.reversed), pairs, countText(check.same), undecided);
    if (check.holds())
        return Experiments::tr("The paper's ranking holds: %1, and all %2 pairs come out as in the "
                               "paper.")
            .arg(own, pairs);
    return Experiments::tr("Nothing contradicts the paper's ranking: %1, %2 of %3 pairs come out "
                           "as in the paper, and %4 are too close to call.")
        .arg(own, countText(check.same), pairs, undecided);
}

/// What the paper's own runs say by our rule, and whether its lines were others.
QStringList paperSentences(const Trial& trial)
{
    const ExperimentOptions& options = trial.record.options;
    QStringList sentences;
    if (rankingCheck(*trial.paper, trial.record, measures().front()).paperTies)
        sentences << Experiments::tr("By the rule used here, the paper's own runs leave its "
                                     "fastest too close to call.");
    if (!otherLinesText(options).isEmpty())
        sentences << Experiments::tr("The paper clipped other lines: %1 random ones; these are %2.")
                         .arg(countText(trial.paper->lines), otherLinesText(options));
    else if (options.lines != trial.paper->lines)
        sentences << Experiments::tr("The paper clipped %1 lines, not %2.")
                         .arg(countText(trial.paper->lines), countText(options.lines));
    return sentences;
}

QStringList lossSentences(const Record& record)
{
    QStringList sentences;
    for (std::size_t i = 0; i < record.timings.size(); ++i) {
        const Findings& found = record.timings[i].found;
        const QString name = nameOf(record.timings[i].contestant);
        const QString visible = countText(found.visible + found.lost - found.shown);
        if (found.lost > 0)
            sentences << Experiments::tr("%1 loses %2 of the %3 lines that are visible.")
                             .arg(name, countText(found.lost), visible);
        if (found.shown > 0)
            sentences << Experiments::tr("%1 shows %2 lines that are not visible.")
                             .arg(name, countText(found.shown));
    }
    const std::size_t visible = record.timings.front().found.visible;
    if (sentences.isEmpty())
        sentences << (visible == 0 ? Experiments::tr("All of them find that no line is visible.")
                                   : Experiments::tr("All of them find the same %1 visible lines.")
                                         .arg(countText(visible)));
    return sentences;
}

} // namespace

RankingCheck rankingCheck(const PaperTable& paper, const Record& record, const Measure& measure)
{
    std::vector<Summary> theirs;
    for (const PaperColumn& column : paper.columns)
        theirs.push_back(summaryOf(column.runs));
    const auto ours = summaries(record, measure);
    RankingCheck check{.paperTies = leaders(theirs).size() > 1};
    for (std::size_t i = 0; i < ours.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (ours[i].confidence.overlaps(ours[j].confidence))
                ++check.undecided;
            else if ((paper.columns[i].printedAverage < paper.columns[j].printedAverage)
                     == (ours[i].median < ours[j].median))
                ++check.same;
            else
                ++check.reversed;
    return check;
}

QStringList verdict(const Trial& trial, std::span<const Measure> measures)
{
    QStringList sentences;
    for (const Measure& measure : measures) {
        if (measure.key == u"draw")
            continue; // it draws what all leave alike
        sentences << leaderSentence(trial.record, measure);
        if (trial.paper)
            sentences.back() += u' ' + rankingSentence(trial, measure);
    }
    QStringList further = lossSentences(trial.record);
    if (trial.paper)
        further << paperSentences(trial);
    return sentences << further.join(u' ');
}

} // namespace app

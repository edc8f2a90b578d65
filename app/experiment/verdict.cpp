// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/verdict.h"

#include "app/base/numbers.h"
#include "app/base/short_names.h"
#include "app/base/text.h"
#include "app/experiment/one_by_one.h"
#include "app/experiment/paper_tables.h"
#include "app/experiment/ranking_text.h"

#include <algorithm>

namespace app {
namespace {

QString shortName(const Record& record, std::size_t i) { return nameAmong(variantsOf(record), i); }

/// "Nicholl-Lee-Nicholl (NLN)".
QString longName(const Record& record, std::size_t i)
{
    const QString name = latin(record.timings[i].variant.algorithm->name);
    const QString brief = shortName(record, i);
    return brief.startsWith(name) ? brief : Text::tr("%1 (%2)").arg(name, brief);
}

QString timesText(double ratio) { return Text::tr("%1 times").arg(numberText(ratio, 2)); }

/// The results by one measure, with their ranking.
struct RankedResults {
    const Record& record;
    const Measure& measure;
    std::vector<Summary> times = summaries(record, measure);
    Ranking ranking = rankingOf(record, measure);

    std::size_t lowest() const { return ranking.order.front(); }
};

/// A variant that loses lines has less work: this must be mentioned if it is the fastest.
bool losesLines(const Record& record, std::size_t i) { return record.timings[i].found.lost > 0; }

/// "22.30 ns a line", "22.30 to 22.41 ns a line": the medians of `some`, which is sorted by them.
QString rangeText(const std::vector<Summary>& times, const std::vector<std::size_t>& some)
{
    const double low = times[some.front()].median, high = times[some.back()].median;
    const QString least = numberText(low, high < 100 ? 2 : 0), most = timeText(high);
    return most.startsWith(least + u' ') ? most : Text::tr("%1 to %2").arg(least, most);
}

/// "; CB, the slowest, takes 2.36 times as long": only if it is significantly slower.
QString slowestText(const RankedResults& told)
{
    const std::size_t last = told.ranking.order.back();
    if (told.ranking.againstLowest(last).outcome != Outcome::Different)
        return {};
    return (told.ranking.ranks[last] ? Text::tr("; %1, the slowest, takes %2 as long")
                                     : Text::tr("; %1, the slowest by median, takes %2 as long"))
        .arg(shortName(told.record, last), timesText(told.ranking.againstLowest(last).ratio));
}

QString leaderName(const Record& record, std::size_t i)
{
    return losesLines(record, i) ? Text::tr("%1 (loses lines)").arg(shortName(record, i))
                                 : shortName(record, i);
}

/// "LB (1.004 times as long, p = 0.23)"
QString testedName(const RankedResults& told, std::size_t i)
{
    const PairTest& test = told.ranking.againstLowest(i);
    return Text::tr("%1 (%2 times as long, p = %3)")
        .arg(leaderName(told.record, i), numberText(test.ratio, 3), pText(test.p));
}

/// " LB (…) does not differ significantly from it." for the variants with one outcome; empty
/// without any. For many variants only their names: the table has ratios and p.
QString outcomeText(const RankedResults& told, Outcome outcome)
{
    constexpr std::ptrdiff_t mostDetailed = 3;
    const auto has = [&](std::size_t i) {
        return i != told.lowest() && told.ranking.againstLowest(i).outcome == outcome;
    };
    const bool detailed = std::ranges::count_if(told.ranking.order, has) <= mostDetailed;
    QStringList names;
    for (const std::size_t i : told.ranking.order)
        if (has(i))
            names << (detailed ? testedName(told, i) : leaderName(told.record, i));
    if (names.isEmpty())
        return {};
    const bool one = names.size() == 1;
    const QString text = outcome == Outcome::PracticallyEqual
                             ? one ? Text::tr(" %1 is practically equal: less than 1 % apart.")
                                   : Text::tr(" %1 are practically equal: less than 1 % apart.")
                         : one ? Text::tr(" %1 does not differ significantly from it.")
                               : Text::tr(" %1 do not differ significantly from it.");
    return text.arg(briefListText(names));
}

/// " The next, LB, takes 1.13 times as long (p = 0.002)."; empty for two, which slowestText covers.
QString nextText(const RankedResults& told)
{
    if (told.ranking.order.size() < 3)
        return {};
    const std::size_t next = told.ranking.order[1];
    return Text::tr(" The next, %1, takes %2 as long (p = %3).")
        .arg(shortName(told.record, next), timesText(told.ranking.againstLowest(next).ratio),
             pText(told.ranking.againstLowest(next).p));
}

QString leaderSentence(const RankedResults& told)
{
    const auto& [record, measure, times, ranking] = told;
    const std::size_t lowest = told.lowest();
    const QString name = longName(record, lowest), time = timeText(times[lowest].median);
    if (times.size() == 1)
        return Text::tr("%1: %2 takes %3.").arg(measure.name, name, time);
    if (!ranking.told)
        return Text::tr("%1: %2 has the lowest median, %3. %4")
            .arg(measure.name, name, time, tooFewRunsText(ranking));
    const auto leaders = ranking.leaders();
    if (leaders.size() == 1)
        return (losesLines(record, lowest)
                    ? Text::tr("%1: %2 is the fastest with %3, but it loses lines%4.")
                    : Text::tr("%1: %2 is the fastest with %3%4."))
                   .arg(measure.name, name, time, slowestText(told))
               + nextText(told);
    if (ranking.groups.size() == 1)
        return Text::tr("%1: no significant difference of 1 % or more; all algorithms take %2.")
            .arg(measure.name, rangeText(times, ranking.order));
    return (losesLines(record, lowest)
                ? Text::tr("%1: %2 has the lowest median, %3, but it loses lines%4.")
                : Text::tr("%1: %2 has the lowest median, %3%4."))
               .arg(measure.name, name, time, slowestText(told))
           + outcomeText(told, Outcome::NotSignificant)
           + outcomeText(told, Outcome::PracticallyEqual);
}

QString proposedText(const RankedResults& told)
{
    const std::size_t proposed = told.times.size() - 1;
    const auto leaders = told.ranking.leaders();
    const QString name = longName(told.record, proposed);
    if (std::ranges::find(leaders, proposed) == leaders.end())
        return Text::tr("its own method, %1, takes %2 as long as the fastest")
            .arg(name, timesText(told.ranking.againstLowest(proposed).ratio));
    return (leaders.size() == 1
                ? Text::tr("its own method, %1, is the fastest")
                : Text::tr("its own method, %1, does not differ significantly by 1 % "
                           "or more from the lowest median"))
        .arg(name);
}

/// "here (Intel Xeon, 2 core(s); GCC 12.2.0)": times are those of one processor and one compiler.
QString hereText(const Record& record)
{
    QStringList names;
    for (const char* key : {"processor", "compiler"})
        for (const auto& [name, value] : record.circumstances)
            if (name == QLatin1StringView(key))
                names << value;
    return names.isEmpty() ? Text::tr("here")
                           : Text::tr("here (%1)").arg(names.join(QStringLiteral("; ")));
}

QString rankingSentence(const Trial& trial, const RankedResults& told)
{
    if (!told.ranking.told)
        return Text::tr("So the paper's ranking can be neither confirmed nor refuted.");
    const auto check = rankingCheck(*trial.paper, trial.record, told.measure);
    const QString own = proposedText(told), here = hereText(trial.record);
    const QString pairs = countText(check.same + check.reversed + check.undecided),
                  undecided = countText(check.undecided);
    if (check.same + check.reversed == 0)
        return Text::tr("The paper's ranking can be neither confirmed nor refuted: none of "
                        "the %1 pairs differs significantly by 1 % or more.")
            .arg(pairs);
    if (check.reversed > 0)
        return Text::tr(
                   "The paper's ranking does not hold %1: %2, and %3 of %4 pairs have the opposite "
                   "order. %5 have the same order, %6 do not differ significantly by 1 % or more.")
            .arg(here, own, countText(check.reversed), pairs, countText(check.same), undecided);
    if (check.holds())
        return Text::tr("The paper's ranking holds %1: %2, and all %3 pairs have the same "
                        "order as in the paper.")
            .arg(here, own, pairs);
    return Text::tr("Nothing contradicts the paper's ranking %1: %2. %3 of %4 pairs have the same "
                    "order as in the paper, and %5 do not differ significantly by 1 % or more.")
        .arg(here, own, countText(check.same), pairs, undecided);
}

/// Which algorithm is the fastest by the times that the paper printed, tested as ours are.
QString paperSentence(const Trial& trial)
{
    QStringList leaders;
    for (const std::size_t i : rankingOf(*trial.paper).leaders())
        leaders << shortNameOf({trial.paper->columns[i].algorithm, clipping::Form::Corrected});
    return leaders.size() == 1
               ? Text::tr("By the same tests, the fastest algorithm in the paper's own runs is %1, "
                          "if they are paired row by row.")
                     .arg(leaders.front())
               : Text::tr("By the same tests, the paper's own runs do not tell which algorithm is "
                          "the fastest, if they are paired row by row: the lowest medians, of %1, "
                          "do not differ significantly.")
                     .arg(briefListText(leaders));
}

/// Which lines the paper clipped instead; empty: the same.
QString otherLinesSentence(const Trial& trial)
{
    const ExperimentOptions& options = trial.record.options;
    if (!otherLinesText(options).isEmpty())
        return Text::tr("The paper clipped other lines: %1 random lines. These are %2.")
            .arg(countText(trial.paper->lines), otherLinesText(options));
    return options.lines == trial.paper->lines
               ? QString()
               : Text::tr("The paper clipped %1 lines, not %2.")
                     .arg(countText(trial.paper->lines), countText(options.lines));
}

QStringList lossSentences(const Record& record)
{
    QStringList sentences;
    for (std::size_t i = 0; i < record.timings.size(); ++i) {
        const Findings& found = record.timings[i].found;
        const QString name = shortNameOf(record.timings[i].variant);
        const QString visible = countText(found.visible + found.lost - found.shown);
        if (found.lost > 0)
            sentences << Text::tr("%1 loses %2 of the %3 visible lines.")
                             .arg(name, countText(found.lost), visible);
        if (found.shown > 0)
            sentences << (found.shown == 1
                              ? Text::tr("%1 shows 1 line that is not visible.").arg(name)
                              : Text::tr("%1 shows %2 lines that are not visible.")
                                    .arg(name, countText(found.shown)));
    }
    const std::size_t visible = record.timings.front().found.visible;
    if (sentences.isEmpty())
        sentences << (visible == 0   ? Text::tr("All algorithms find that no line is visible.")
                      : visible == 1 ? Text::tr("All algorithms find the same visible line.")
                                     : Text::tr("All algorithms find the same %1 visible lines.")
                                           .arg(countText(visible)));
    return sentences;
}

} // namespace

RankingCheck rankingCheck(const PaperTable& paper, const Record& record, const Measure& measure)
{
    const Ranking ours = rankingOf(record, measure);
    const auto times = summaries(record, measure);
    RankingCheck check;
    for (std::size_t i = 0; i < times.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (!ours.told || ours.pairs[i][j].outcome != Outcome::Different)
                ++check.undecided;
            else if ((paper.columns[i].printedAverage < paper.columns[j].printedAverage)
                     == (times[i].median < times[j].median))
                ++check.same;
            else
                ++check.reversed;
    return check;
}

QStringList verdict(const Trial& trial, std::span<const Measure> measures)
{
    QStringList sentences;
    if (const QString others = trial.paper ? otherLinesSentence(trial) : QString();
        !others.isEmpty())
        sentences << others;
    for (const Measure& measure : measures) {
        if (measure.key == u"draw")
            continue; // all variants leave the same lines to draw
        const RankedResults told{trial.record, measure};
        sentences << leaderSentence(told);
        if (trial.paper)
            sentences.back() += u' ' + rankingSentence(trial, told);
    }
    QStringList further = lossSentences(trial.record);
    if (const QString batches = batchText(trial.record); !batches.isEmpty())
        further.prepend(batches);
    if (trial.paper)
        further << paperSentence(trial);
    return sentences << further.join(u' ');
}

} // namespace app

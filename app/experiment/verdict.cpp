// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/verdict.h"

#include "app/view/numbers.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {
namespace {

struct Experiments {
    Q_DECLARE_TR_FUNCTIONS(Experiments)
};

QString latin(std::string_view text)
{
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

/// "KWC as published" where both forms take part, else "KWC".
QString shortName(const Record& record, std::size_t i)
{
    const auto& timings = record.timings;
    const Contestant& one = timings[i].contestant;
    const bool mixed = std::ranges::any_of(
        timings, [&](const Timing& timing) { return timing.contestant.form != one.form; });
    const QString name = latin(one.algorithm->abbreviation);
    return mixed && one.form == clipping::Form::Published
               ? Experiments::tr("%1 as published").arg(name)
               : name;
}

/// "Nicholl-Lee-Nicholl (NLN)".
QString longName(const Record& record, std::size_t i)
{
    return Experiments::tr("%1 (%2)").arg(latin(record.timings[i].contestant.algorithm->name),
                                          shortName(record, i));
}

/// "CS, LB and MD".
QString listText(const QStringList& names)
{
    if (names.size() < 2)
        return names.join(QString());
    return Experiments::tr("%1 and %2")
        .arg(names.sliced(0, names.size() - 1).join(QStringLiteral(", ")), names.back());
}

QString timeText(double nanoseconds)
{
    return Experiments::tr("%1 ns a line").arg(numberText(nanoseconds, nanoseconds < 100 ? 2 : 0));
}

QString timesText(double ratio) { return Experiments::tr("%1 times").arg(numberText(ratio, 2)); }

/// The fastest one, or those that tie with it, by median.
std::vector<std::size_t> leaders(const std::vector<Summary>& times,
                                 const std::vector<Standing>& places)
{
    std::vector<std::size_t> first;
    const auto order = sortedByMedian(times);
    for (const std::size_t i : order)
        if (i == order.front() || (places[i].tie && places[i].tie == places[order.front()].tie))
            first.push_back(i);
    return first;
}

QString leaderSentence(const Record& record, const Measure& measure)
{
    const auto times = summaries(record, measure);
    const auto order = sortedByMedian(times);
    const auto first = leaders(times, standings(times));
    if (times.size() == 1)
        return Experiments::tr("%1: %2 takes %3.")
            .arg(measure.name, longName(record, 0), timeText(times[0].median));
    const double fastest = times[order.front()].median;
    const QString slowest =
        Experiments::tr("%1, the slowest, takes %2 as long")
            .arg(shortName(record, order.back()), timesText(times[order.back()].median / fastest));
    if (first.size() == times.size())
        return Experiments::tr("%1: too close to call, all of them take about %2.")
            .arg(measure.name, timeText(fastest));
    if (first.size() == 1)
        return Experiments::tr("%1: %2 is the fastest with %3; %4.")
            .arg(measure.name, longName(record, order.front()), timeText(fastest), slowest);
    QStringList names;
    for (const std::size_t i : first)
        names << shortName(record, i);
    return Experiments::tr("%1: %2 are the fastest with about %3, too close to call; %4.")
        .arg(measure.name, listText(names), timeText(fastest), slowest);
}

QString proposedText(const Record& record, const Measure& measure)
{
    const auto times = summaries(record, measure);
    const auto first = leaders(times, standings(times));
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
    const std::size_t pairs = check.same + check.reversed + check.undecided;
    const QString own = proposedText(trial.record, measure);
    if (!check.holds())
        return Experiments::tr("The paper's ranking does not hold for that: %1, and %2 of %3 pairs "
                               "come out the other way round (%4 are too close to call, there or "
                               "here).")
            .arg(own, countText(check.reversed), countText(pairs), countText(check.undecided));
    return Experiments::tr(
               "The paper's ranking holds for that as far as it can be told: %1, and no "
               "pair comes out the other way round (%2 of %3 are too close to call, "
               "there or here).")
        .arg(own, countText(check.undecided), countText(pairs));
}

QStringList lossSentences(const Record& record)
{
    QStringList sentences;
    for (std::size_t i = 0; i < record.timings.size(); ++i) {
        const auto& [contestant, generate, clip, draw, found, pixels] = record.timings[i];
        const QString name =
            contestant.form == clipping::Form::Published
                ? Experiments::tr("%1 as published").arg(latin(contestant.algorithm->abbreviation))
                : latin(contestant.algorithm->abbreviation);
        const QString visible = countText(found.visible + found.lost - found.shown);
        if (found.lost > 0)
            sentences << Experiments::tr("%1 loses %2 of the %3 lines that are visible.")
                             .arg(name, countText(found.lost), visible);
        if (found.shown > 0)
            sentences << Experiments::tr("%1 shows %2 lines that are not visible.")
                             .arg(name, countText(found.shown));
    }
    if (sentences.isEmpty())
        sentences << Experiments::tr("All of them find the same %1 visible lines.")
                         .arg(countText(record.timings.front().found.visible));
    return sentences;
}

QString shareText(double share) { return QString::number(100 * share, 'f', share < 0.1 ? 1 : 0); }

} // namespace

RankingCheck rankingCheck(const PaperTable& paper, const Record& record, const Measure& measure)
{
    std::vector<Summary> theirs;
    for (const PaperColumn& column : paper.columns)
        theirs.push_back(summaryOf(column.runs));
    const auto ours = summaries(record, measure);
    const auto theirPlaces = standings(theirs), ourPlaces = standings(ours);
    const auto tied = [](const Standing& a, const Standing& b) { return a.tie && a.tie == b.tie; };
    RankingCheck check;
    for (std::size_t i = 0; i < ours.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (tied(theirPlaces[i], theirPlaces[j]) || tied(ourPlaces[i], ourPlaces[j]))
                ++check.undecided;
            else if ((theirs[i].median < theirs[j].median) == (ours[i].median < ours[j].median))
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
    return sentences + QStringList(lossSentences(trial.record).join(u' '));
}

QStringList reasons(const Explanation& explanation)
{
    const auto& classes = explanation.classes.classes;
    const auto most =
        std::ranges::max_element(classes, {}, [](const ClassTimes& one) { return one.of.share; });
    if (most == classes.end() || most->record.timings.empty())
        return {};
    const auto times = summaries(most->record, measures().front());
    const auto order = sortedByMedian(times);
    const auto of = [&](std::size_t i) {
        return Experiments::tr("%1 with %2")
            .arg(shortName(most->record, i), timeText(times[i].median));
    };
    return {Experiments::tr("%1 % of the lines: %2. For those the fastest is %3, the slowest %4.")
                .arg(shareText(most->of.share), words(most->of.lineClass), of(order.front()),
                     of(order.back()))};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/ranking_text.h"

#include "app/base/text.h"

#include <cmath>

namespace app {
namespace {

QString lettersMeaning()
{
    return Text::tr("Algorithms that share no letter differ significantly, by 1 % or more.");
}

} // namespace

QString groupLetter(std::size_t group)
{
    const QString last(QChar(u'a' + char16_t(group % 26)));
    return group < 26 ? last : groupLetter(group / 26 - 1) + last;
}

QString rankText(const Ranking& ranking, std::size_t thing)
{
    const auto rank = ranking.ranks[thing];
    return rank ? QString::number(*rank) : QString();
}

QString lettersText(const Ranking& ranking, std::size_t thing)
{
    QStringList letters;
    for (const std::size_t group : ranking.groupsOf(thing))
        letters << groupLetter(group);
    return letters.join(u' ');
}

QString pText(double p) { return QString::number(p, 'g', 3); }

QString ratioToFastestText(const Ranking& ranking, std::size_t thing)
{
    const double ratio = ranking.againstLowest(thing).ratio;
    return thing == ranking.order.front() || !std::isfinite(ratio) ? QString()
                                                                   : QString::number(ratio, 'f', 3);
}

QString pToFastestText(const Ranking& ranking, std::size_t thing)
{
    return thing == ranking.order.front() || !ranking.told ? QString()
                                                           : pText(ranking.againstLowest(thing).p);
}

QString tooFewRunsText(const Ranking& ranking)
{
    return ranking.told
               ? QString()
               : Text::tr("Too few runs: %3 algorithms need %2 runs, but this experiment has %1.")
                     .arg(ranking.rounds)
                     .arg(leastRounds(ranking.order.size()))
                     .arg(ranking.order.size());
}

QStringList rankingNotes(const Ranking& ranking)
{
    if (ranking.order.size() < 2)
        return {};
    if (!ranking.told)
        return {tooFewRunsText(ranking)};
    return {lettersMeaning()
            + Text::tr(
                " All pairs are tested by the exact two-sided Wilcoxon signed-rank test, paired by "
                "run, at a level of 5 %, with Holm's correction. The fastest is the one that "
                "differs so from all others: it shares no letter. Without a rank is what does not "
                "differ so from every other.")};
}

QStringList ratioNotes(const Ranking& ranking)
{
    if (ranking.order.size() < 2)
        return {};
    const QString ratio =
        Text::tr("Ratio: the ratio to the lowest median, as the median of the ratios run by run.");
    return {ranking.told
                ? ratio
                      + Text::tr(
                          " p: the p-value of the test against the lowest median, one of the tests "
                          "of all pairs, with Holm's correction. A significant difference of less "
                          "than 1 % counts as practically equal.")
                : ratio};
}

QString rankingText(const QStringList& names, const Ranking& ranking)
{
    QStringList all;
    for (const std::size_t i : ranking.order)
        all << (ranking.told
                    ? QStringLiteral("%1 (%2)").arg(names[qsizetype(i)], lettersText(ranking, i))
                    : names[qsizetype(i)]);
    return Text::tr("From the lowest median to the highest: %1. %2")
        .arg(all.join(QStringLiteral(", ")),
             ranking.told ? lettersMeaning() : tooFewRunsText(ranking));
}

QString boundText(double time)
{
    if (!std::isfinite(time))
        return {};
    return time > 0 && time < 0.005 ? QString::number(time, 'g', 2) : QString::number(time, 'f', 2);
}

} // namespace app

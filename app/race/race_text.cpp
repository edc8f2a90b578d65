// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/race/race_text.h"

#include "app/base/numbers.h"
#include "app/base/short_names.h"
#include "app/base/text.h"
#include "app/view/frame_times.h"

namespace app {
Ranking rankingOf(std::span<const RaceRow> rows)
{
    std::vector<std::vector<double>> runs;
    for (const RaceRow& row : rows)
        runs.emplace_back(row.times().begin(), row.times().end());
    return rankingOf(PairedRuns(runs));
}

QString groupsText(std::span<const RaceRow> rows, const Ranking& ranking)
{
    if (!ranking.told)
        return Text::tr("Too few rounds: %3 algorithms need %2 rounds, but this race has %1.")
            .arg(ranking.rounds)
            .arg(leastRounds(rows.size()))
            .arg(rows.size());
    QStringList texts;
    for (const auto& group : ranking.groups) {
        QStringList names;
        for (const std::size_t i : group)
            names << shortNameOf(rows[i].variant);
        if (names.size() > 1)
            texts << listText(names);
    }
    return texts.isEmpty() ? QString()
                           : Text::tr("No significant difference of 1 % or more: %1")
                                 .arg(texts.join(QStringLiteral("; ")));
}

QString shortTimeText(double milliseconds)
{
    if (milliseconds >= 0.1)
        return millisecondsText(milliseconds);
    const double micro = milliseconds * 1e3;
    return Text::tr("%1 µs").arg(numberText(micro, micro < 10 ? 2 : 1));
}

QString figuresText(const FormResult& result, bool timed)
{
    if (!result.measured())
        return {};
    QStringList figures;
    if (timed)
        figures << Text::tr("%1 ± %2").arg(shortTimeText(result.summary.median),
                                           shortTimeText(result.summary.spread / 2));
    figures << Text::tr("%1 operations per line").arg(numberText(result.row.operations, 1))
            << (result.row.visible == 1
                    ? Text::tr("1 visible line")
                    : Text::tr("%1 visible lines").arg(countText(result.row.visible)));
    if (const std::size_t differing = result.row.differences.all())
        figures << (differing == 1 ? Text::tr("1 differs")
                                   : Text::tr("%1 differ").arg(countText(differing)));
    const bool published = result.row.variant.form == clipping::Form::Published;
    return (published ? Text::tr("As published: %1") : Text::tr("Corrected: %1"))
        .arg(figures.join(Text::tr(", ")));
}

QString placeText(const QString& where, const RaceLane& lane)
{
    if (where.isEmpty())
        return {};
    return lane.most > 0
               ? Text::tr("%1 and differences: %2 only, all can clip it").arg(lane.unit(), where)
               : Text::tr("Differences: %1 only, all can clip it").arg(where);
}

QString fieldText(std::size_t lines)
{
    return (lines < leastLinesToTime ? Text::tr("%1: too few to time")
                                     : Text::tr("%1, rotated order, 1 thread"))
        .arg(linesText(lines));
}

QString tooFewText(std::size_t lines)
{
    return lines >= leastLinesToTime
               ? QString()
               : Text::tr("Clipping fewer than %1 lines is over too soon for a reliable time, so "
                          "only results and operations are compared. Open a drawing with more "
                          "lines to compare times.")
                     .arg(countText(leastLinesToTime));
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/race_text.h"

#include "app/experiment/contestant_name.h"
#include "app/view/frame_statistics.h"
#include "app/view/numbers.h"

#include <QCoreApplication>

namespace app {
namespace {

struct Races {
    Q_DECLARE_TR_FUNCTIONS(Races)
};

} // namespace

QString tiesText(std::span<const RaceRow> rows)
{
    std::vector<Summary> summaries;
    for (const RaceRow& row : rows)
        summaries.push_back(row.summary());
    QStringList texts;
    for (const auto& group : tieGroups(summaries)) {
        QStringList names;
        for (const std::size_t i : group)
            names << nameOf(rows[i].contestant);
        texts << Races::tr("%1 tie").arg(listText(names));
    }
    return texts.isEmpty()
               ? QString()
               : Races::tr("%1: too close to call").arg(texts.join(QStringLiteral(", ")));
}

QString shortTimeText(double milliseconds)
{
    if (milliseconds >= 0.1)
        return millisecondsText(milliseconds);
    const double micro = milliseconds * 1e3;
    return Races::tr("%1 µs").arg(numberText(micro, micro < 10 ? 2 : 1));
}

QString fieldText(std::size_t lines)
{
    const QString count = countText(lines);
    return lines < leastLinesToTime ? Races::tr("%1 lines: too few to time").arg(count)
                                    : Races::tr("%1 lines, rotated order, 1 thread").arg(count);
}

} // namespace app

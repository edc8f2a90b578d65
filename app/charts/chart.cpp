// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/chart.h"

#include "app/base/text.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace app {

double Bar::length() const { return std::accumulate(parts.begin(), parts.end(), 0.0); }

Box boxOf(std::span<const double> numbers)
{
    std::vector<double> sorted;
    std::ranges::copy_if(numbers, std::back_inserter(sorted),
                         [](double x) { return std::isfinite(x); });
    assert(!sorted.empty() && sorted.size() == numbers.size());
    if (sorted.empty())
        return {};
    std::ranges::sort(sorted);
    const Interval quartiles{quantile(sorted, 0.25), quantile(sorted, 0.75)};
    const double reach = 1.5 * (quartiles.high - quartiles.low);
    const auto within = [&](double x) {
        return quartiles.low - reach <= x && x <= quartiles.high + reach;
    };
    Box box{{}, quartiles, quantile(sorted, 0.5)};
    std::ranges::copy_if(sorted, std::back_inserter(box.outliers),
                         [&](double x) { return !within(x); });
    std::erase_if(sorted, [&](double x) { return !within(x); });
    box.whiskers = {std::min(sorted.front(), quartiles.low),
                    std::max(sorted.back(), quartiles.high)};
    return box;
}

QString textOf(const Chart& chart)
{
    QStringList lines(chart.title);
    if (!chart.subtitle.isEmpty())
        lines << chart.subtitle;
    for (const ChartRow& row : chart.rows)
        lines << QString(row.detail).replace(u'\n', QStringLiteral("; "));
    for (const RowGroup& group : chart.groups) {
        QStringList names;
        for (const std::size_t i : group.rows)
            names << chart.rows[i].name;
        lines << Text::tr("Bracket %1: %2 do not differ significantly by 1 % "
                          "or more.")
                     .arg(group.letter, names.join(QStringLiteral(", ")));
    }
    return (lines + chart.notes).join(u'\n');
}

} // namespace app

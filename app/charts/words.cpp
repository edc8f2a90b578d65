// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/words.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/experiment/ranking_text.h"

#include <algorithm>

namespace app {

ChartRow rowFor(const Variant& variant)
{
    const std::string_view name = variant.algorithm->abbreviation;
    const bool published = variant.form == clipping::Form::Published;
    return {.variant = variant,
            .name = latin(name),
            .note = published ? Text::tr("as published") : QString(),
            .figures = {}};
}

QString fullName(const Variant& variant)
{
    const std::string_view name = variant.algorithm->name;
    const QString text = latin(name);
    return variant.form == clipping::Form::Published ? Text::tr("%1, as published").arg(text)
                                                     : text;
}

Chart withSharedNote(Chart chart)
{
    const QString note = chart.rows.empty() ? QString() : chart.rows.front().note;
    if (note.isEmpty()
        || std::ranges::any_of(chart.rows, [&](const ChartRow& row) { return row.note != note; }))
        return chart;
    for (ChartRow& row : chart.rows)
        row.note.clear();
    chart.subtitle = Text::tr("%1; algorithms %2").arg(chart.subtitle, note);
    return chart;
}

QString nanosecondsText(double nanoseconds)
{
    const int decimals = nanoseconds < 10 ? 2 : nanoseconds < 100 ? 1 : 0;
    return Text::tr("%1 ns").arg(numberText(nanoseconds, decimals));
}

QString sceneText(const ExperimentOptions& options)
{
    return Text::tr("Scene “%1”, %2 lines").arg(options.scene.name, countText(options.lines));
}

std::vector<RowGroup> groupsOf(const Ranking& ranking, std::span<const std::size_t> order)
{
    std::vector<RowGroup> groups;
    for (std::size_t g = 0; g < ranking.groups.size(); ++g) {
        RowGroup group{.rows = {}, .letter = groupLetter(g)};
        for (std::size_t row = 0; row < order.size(); ++row)
            if (std::ranges::find(ranking.groups[g], order[row]) != ranking.groups[g].end())
                group.rows.push_back(row);
        if (group.rows.size() > 1)
            groups.push_back(std::move(group));
    }
    return groups;
}

QStringList groupNotes(const Ranking& ranking)
{
    if (!ranking.told)
        return {tooFewRunsText(ranking)};
    const bool brackets =
        std::ranges::any_of(ranking.groups, [](const auto& group) { return group.size() > 1; });
    return brackets ? QStringList(Text::tr("A bracket joins algorithms that do not differ "
                                           "significantly by 1 % or more."))
                    : QStringList();
}

} // namespace app

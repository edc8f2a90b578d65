// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/race/race_pairs.h"

#include "app/base/text.h"

#include <QSet>
#include <QStringList>

#include <algorithm>

namespace app {

std::vector<RacePair> pairsOf(std::span<const RaceRow> rows)
{
    std::vector<RacePair> pairs;
    for (const RaceRow& row : rows) {
        auto found = std::ranges::find(pairs, row.variant.algorithm, &RacePair::algorithm);
        if (found == pairs.end())
            found = pairs.insert(found, {.algorithm = row.variant.algorithm});
        auto& place =
            row.variant.form == clipping::Form::Published ? found->published : found->corrected;
        place = FormResult{row, row.summary()};
    }
    return pairs;
}

bool anyIn(std::span<const RacePair> pairs, clipping::Form form)
{
    return std::ranges::any_of(pairs,
                               [form](const RacePair& pair) { return pair.of(form).has_value(); });
}

QString briefName(const clipping::Algorithm& algorithm)
{
    constexpr qsizetype many = 3;
    const QString name = latin(algorithm.name);
    const QStringList people = name.split(u'-');
    const bool brief = QSet<QString>(people.begin(), people.end()).size() >= many;
    return brief ? Text::tr("%1 et al.").arg(people.front()) : name;
}

} // namespace app

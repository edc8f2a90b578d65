// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/reasons.h"

#include "app/base/numbers.h"
#include "app/base/short_names.h"
#include "app/base/text.h"
#include "app/experiment/ranking_text.h"

#include <algorithm>

namespace app {
namespace {

template <class Rows>
std::vector<Variant> variantsOf(const Rows& rows)
{
    std::vector<Variant> all;
    all.reserve(rows.size());
    for (const auto& row : rows)
        all.push_back(row.variant);
    return all;
}

QString shareText(double share) { return numberText(100 * share, share < 0.1 ? 1 : 0); }

/// " LB and MD do not differ significantly from it by 1 % or more.", or why there is no result;
/// empty if exactly one is the fastest.
QString unclearText(const std::vector<Variant>& all, const Ranking& ranking)
{
    if (!ranking.told)
        return u' ' + tooFewRunsText(ranking);
    QStringList names;
    for (const std::size_t i : ranking.leaders())
        names << nameAmong(all, i);
    if (names.size() < 2)
        return {};
    return (names.size() == 2
                ? Text::tr(" %1 does not differ significantly from it by 1 % or more.")
                : Text::tr(" %1 do not differ significantly from it by 1 % or more."))
        .arg(briefListText(names.sliced(1)));
}

QString classReason(const ClassProfile& profile)
{
    const auto most = std::ranges::max_element(profile.classes, {},
                                               [](const ClassTimes& one) { return one.of.share; });
    if (most == profile.classes.end() || most->record.timings.empty())
        return {};
    const auto all = variantsOf(most->record.timings);
    const auto times = summaries(most->record, measures().front());
    const Ranking ranking = rankingOf(most->record, measures().front());
    const auto of = [&](std::size_t i) {
        return Text::tr("%1 with %2").arg(nameAmong(all, i), timeText(times[i].median));
    };
    const QString unclear = unclearText(all, ranking);
    return (unclear.isEmpty()
                ? Text::tr("Most lines, %1 %, are of the class “%2”. For this class, the "
                           "fastest algorithm is %3; the highest median is that of %4.")
                : Text::tr("Most lines, %1 %, are of the class “%2”. For this class, the "
                           "lowest median is that of %3, the highest that of %4."))
               .arg(shareText(most->of.share), classText(most->of.lineClass), of(ranking.order.front()),
                    of(ranking.order.back()))
           + unclear;
}

QString operationReason(const OperationProfile& profile)
{
    const auto all = variantsOf(profile.rows);
    const auto perLine = [&](const VariantOperations& row) {
        return double(promisedOf(row.scene())) / double(profile.options.lines);
    };
    const auto [fewest, most] = std::ranges::minmax_element(profile.rows, {}, perLine);
    const auto of = [&](auto row) {
        return nameAmong(all, std::size_t(row - profile.rows.begin()));
    };
    return Text::tr(
               "%1 needs the fewest operations, %2 per line; %3 needs the most, %4. A branch that "
               "the processor mispredicts costs as much as many operations.")
        .arg(of(fewest), numberText(perLine(*fewest), 1), of(most), numberText(perLine(*most), 1));
}

/// The faults of a variant.
QString faultText(const Accuracy& row)
{
    QStringList faults;
    const auto add = [&](std::uint64_t count, const QString& one, const QString& many) {
        if (count > 0)
            faults << (count == 1 ? one : many.arg(countText(count)));
    };
    add(row.lost, Text::tr("drops 1 visible line"), Text::tr("drops %1 visible lines"));
    add(row.shown, Text::tr("shows 1 line that is not visible"),
        Text::tr("shows %1 lines that are not visible"));
    add(row.outside, Text::tr("leaves an end of 1 line outside the window"),
        Text::tr("leaves ends of %1 lines outside the window"));
    return faults.isEmpty() ? QString()
                            : Text::tr("%1 %2.").arg(shortNameOf(row.variant), listText(faults));
}

QString accuracyReason(const std::vector<Accuracy>& accuracies)
{
    QStringList sentences;
    for (const Accuracy& row : accuracies)
        if (const QString text = faultText(row); !text.isEmpty())
            sentences << text;
    return sentences.isEmpty() ? Text::tr("All algorithms find the same lines as exact "
                                          "arithmetic, and no end is outside the window.")
                               : sentences.join(u' ');
}

} // namespace

QStringList reasons(const Explanation& explanation)
{
    return {classReason(explanation.classes), operationReason(explanation.operations),
            accuracyReason(explanation.accuracies)};
}

} // namespace app

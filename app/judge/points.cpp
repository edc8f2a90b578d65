// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/points.h"

#include "app/base/text.h"

#include <algorithm>

namespace app::plug_in {
namespace {

constexpr int unfinished = -1, untested = -2; ///< instead of points: the time was up

/// Whole tenths that are right, of what was tested and of what was not. In whole numbers, because
/// of ten lines with nine wrong ones, 1 − 0.9 is less than a tenth.
int tenthsRight(const CategoryCount& count, std::size_t wrong, std::size_t all)
{
    const std::size_t right = all == 0 ? 1 : all - std::min(wrong, all);
    return int(fullPoints * right * count.judged
               / (std::max<std::size_t>(1, all) * std::max<std::size_t>(1, count.lines)));
}

} // namespace

int pointsOf(const CategoryCount& count)
{
    if (count.wrong == 0 && count.judged >= count.lines)
        return fullPoints;
    return std::min(
        {fullPoints - 1, tenthsRight(count, count.wrongVisible, count.visible),
         tenthsRight(count, count.wrong - count.wrongVisible, count.judged - count.visible)});
}

std::span<const Degree> degrees()
{
    static const std::vector<Degree> all{
        {fullPoints, "right", Text::tr("right")},
        {fullPoints - 1, "nearly", Text::tr("nearly right")},
        {fullPoints / 2, "mostly", Text::tr("mostly right")},
        {1, "partly", Text::tr("partly right")},
        {0, "wrong", Text::tr("wrong")},
        {unfinished, "unfinished", Text::tr("right so far")},
        {untested, "untested", Text::tr("not tested")},
    };
    return all;
}

const Degree& degreeOf(const CategoryCount& count)
{
    const bool isRightSoFar = count.wrong == 0 && count.judged < count.lines;
    const int points = !isRightSoFar ? pointsOf(count) : count.judged == 0 ? untested : unfinished;
    return *std::ranges::find_if(degrees(),
                                 [=](const Degree& one) { return points >= one.points; });
}

Score scoreOf(const Verdict& verdict)
{
    Score score;
    for (const CategoryCount& count : verdict.categories) {
        const int points = pointsOf(count);
        score.points += points;
        score.right += points == fullPoints;
    }
    score.categories = verdict.categories.size();
    score.most = fullPoints * int(score.categories);
    return score;
}

} // namespace app::plug_in

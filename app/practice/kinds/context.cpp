// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/practice/kinds/kinds.h"

#include <algorithm>
#include <cmath>

namespace app {

clipping::Segment MoveContext::leftBefore(std::size_t index) const
{
    return index == 0 ? tracedLine.line : narration.steps[index - 1].left;
}

std::optional<std::size_t> MoveContext::nextCut() const
{
    for (std::size_t k = step; k < trace.steps.size(); ++k) {
        if (k > step && trace.steps[k].label == trace.steps[step].label)
            return std::nullopt;
        if (trace.steps[k].what == clipping::What::Cut)
            return k;
    }
    return std::nullopt;
}

std::optional<int> MoveContext::movedEnd(std::size_t cut) const
{
    const clipping::Segment before = leftBefore(cut), &after = narration.steps[cut].left;
    if (before.a != after.a)
        return 1;
    return before.b != after.b ? std::optional(2) : std::nullopt;
}

Point MoveContext::endBefore(int end) const
{
    const clipping::Segment left = leftBefore(step);
    return end == 1 ? left.a : left.b;
}

QString MoveContext::codeText(int line) const { return narration.code.value(line - 1).trimmed(); }

void addMistake(Move& move, std::string_view kind, double answer, const QString& hint)
{
    if (!std::isfinite(answer) || isRight(move, answer) || mistakeOf(move, answer))
        return;
    move.mistakes.push_back({kind, answer, hint});
}

} // namespace app

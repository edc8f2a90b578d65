// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/practice/move.h"

#include "app/base/text.h"
#include "app/practice/kinds/kinds.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace app {

bool isRight(const Move& move, double answer)
{
    return std::abs(answer - move.right) <= move.within;
}

const Mistake* mistakeOf(const Move& move, double answer)
{
    if (isRight(move, answer))
        return nullptr;
    const auto distance = [&](const Mistake& m) { return std::abs(answer - m.answer); };
    const auto nearest = std::ranges::min_element(move.mistakes, {}, distance);
    return nearest != move.mistakes.end() && distance(*nearest) <= move.within ? &*nearest
                                                                               : nullptr;
}

QString alsoIn(MoveKind kind)
{
    const char* const sentence = makerOf(kind).alsoIn;
    return sentence ? Text::tr(sentence) : QString();
}

QString answerText(const Move& move, double answer, YAxis y)
{
    return makerOf(move.kind).text(move, answer, y);
}

std::vector<Move> movesOf(const TracedLine& tracedLine)
{
    const auto plan = planOf(tracedLine.variant);
    if (plan.empty() || !tracedLine.corners.empty())
        return {};
    const auto& [algorithm, form, misprint] = tracedLine.variant;
    const Narration narration = narrationOf(tracedLine);
    const clipping::Trace trace =
        clipping::functionsOf(*algorithm, form)->trace(tracedLine.line, tracedLine.window);
    const auto code = clipping::linesOf(clipping::codeOf(*algorithm, form));
    std::vector<Move> moves;
    std::map<const PlannedMove*, int> made;
    for (std::size_t step = 0; step < narration.steps.size(); ++step)
        for (const PlannedMove& planned : plan) {
            if (trace.steps[step].label != planned.label || made[&planned] >= planned.most)
                continue;
            auto move =
                makerOf(planned.kind).make({tracedLine, narration, trace, code, planned, step});
            if (!move)
                continue;
            move->kind = planned.kind;
            move->step = step;
            ++made[&planned];
            moves.push_back(std::move(*move));
        }
    return moves;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/random.h"
#include "app/practice/practice.h"
#include "app/teaching/narration.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// Players of Do it yourself, for tests.

namespace app::playing {

inline double valueAfter(const NarratedStep& step, const QString& name)
{
    const auto variable = std::ranges::find(step.variables, name, &Variable::name);
    return variable == step.variables.end() ? std::nan("") : variable->value;
}

/// The next step that moves an end, and where it is then.
inline double nextCut(const TracedLine& traced, const Narration& narration, std::size_t step,
                      bool asEdge)
{
    for (std::size_t k = step; k < narration.steps.size(); ++k) {
        const clipping::Segment before = k == 0 ? traced.line : narration.steps[k - 1].left;
        const clipping::Segment& after = narration.steps[k].left;
        if (narration.steps[k].mark != Mark::Cut || before == after)
            continue;
        if (asEdge)
            return double(narration.steps[k].edge);
        const Point p = before.a != after.a ? after.a : after.b;
        return glm::distance(p, traced.line.a) / glm::distance(traced.line.b, traced.line.a);
    }
    return std::nan("");
}

/// What the steps up to the next one that is no test, or moves an end or computes, make of it.
inline double decisionOf(const Narration& narration, const Move& move)
{
    const auto& steps = narration.steps;
    for (std::size_t k = move.step; k < steps.size(); ++k) {
        if (steps[k].mark == Mark::Accept)
            return double(Decision::Accept);
        if (steps[k].mark == Mark::Reject)
            return double(Decision::Reject);
        const bool ends = std::ranges::any_of(steps[k].variables, [](const Variable& v) {
            return v.name == QStringLiteral("display") && v.value == 0;
        });
        const QString code = narration.code.value(steps[k].line - 1).trimmed();
        if (k > move.step && !ends && !code.startsWith(QStringLiteral("hold"))
            && !(steps[k].answer && k == move.step + 1
                 && (code.contains(u'&') || code.contains(QStringLiteral("y1 < ymin and")))))
            return double(Decision::GoOn);
    }
    return double(Decision::GoOn);
}

/// The answer that the trace gives, read from it without the move's own answer.
inline double answerOfTrace(const TracedLine& traced, const Narration& narration, const Move& move)
{
    const NarratedStep& step = narration.steps[move.step];
    switch (move.kind) {
    case MoveKind::Bits:
    case MoveKind::Value:
        return valueAfter(step, move.name);
    case MoveKind::Edge:
        if (move.name.isEmpty())
            return nextCut(traced, narration, move.step, true);
        return std::array{3, 2, 4, 1}.at(std::size_t(valueAfter(step, move.name)));
    case MoveKind::Place:
        return nextCut(traced, narration, move.step, false);
    case MoveKind::Line:
        return narration.steps[move.step + 1].line;
    case MoveKind::Decide:
        return decisionOf(narration, move);
    }
    return 0;
}

/// A random answer of the move's kind.
inline double randomAnswer(const Move& move, std::size_t linesOfCode, Random& random)
{
    const auto below = [&](double count) { return std::floor(random.between(0, count)); };
    switch (move.kind) {
    case MoveKind::Bits:
        return below(16);
    case MoveKind::Edge:
        return 1 + below(4);
    case MoveKind::Place:
        return random.between(0, 1);
    case MoveKind::Line:
        return 1 + below(double(linesOfCode));
    case MoveKind::Value:
        return random.between(-200, 200);
    case MoveKind::Decide:
        return below(3);
    }
    return 0;
}

} // namespace app::playing

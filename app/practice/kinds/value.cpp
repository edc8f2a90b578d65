// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/practice/alterations.h"
#include "app/practice/kinds/kinds.h"
#include "app/teaching/code_line.h"
#include "app/teaching/sentences/code_values.h"
#include "app/teaching/sentences/words.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double share = 0.005; // of the value: three digits are enough

/// The formula of a variable as the line has it: "q/p".
QString formulaOf(const MoveContext& context, const QString& name)
{
    for (const Assignment& assignment :
         assignmentsIn(context.codeText(context.now().line), context.narration.code))
        if (assignment.name == name || assignment.name.section(u'[', 0, 0) == name)
            return assignment.formula;
    return {};
}

std::optional<Move> makeValue(const MoveContext& context)
{
    const auto& values = context.traced().values;
    const auto value =
        std::ranges::find(values, context.planned.variable, &clipping::NamedValue::name);
    if (value == values.end() || !std::isfinite(value->value))
        return std::nullopt;
    const auto wrong = alterationsOf(context);
    const QString name = latin(value->name), formula = formulaOf(context, name);
    if (!wrong || formula.isEmpty())
        return std::nullopt;
    const int line = context.now().line;
    const SentenceContext sentence{context.tracedLine, context.traced(), nullptr,
                                   context.now().variables};
    const QString numbers = filledIn(formula, CodeValues(sentence, {name}));
    Move move{
        .prompt =
            Text::tr("Line %1: %2 = %3. Compute %2 to three digits.").arg(line).arg(name, formula),
        .brief = Text::tr("Value of %1").arg(name),
        .right = value->value,
        .within = share * std::max(1.0, std::abs(value->value)),
        .chance = 0.01,
        .hint = Text::tr("Put the numbers in: %1 = %2.").arg(name, numbers)};
    move.line = line;
    move.name = name;
    move.reason = Text::tr("%1 = %2 = %3.").arg(name, numbers, words::number(value->value));
    for (const Alteration& alteration : *wrong)
        addMistake(move, alteration.kind, alteration.value, alteration.hint);
    return move;
}

QString valueAnswerText(const Move&, double answer, YAxis) { return words::number(answer); }

} // namespace

const MoveMaker valueMaker{MoveKind::Value, makeValue, valueAnswerText};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/teaching/formulas/step_check.h"

namespace app::formulas {

/// Parameters that are told have the values of the arguments of one of the line's calls.
void StepCheck::arguments(const clipping::Step& step)
{
    std::optional<Wrong> wrong;
    for (const Arguments& call : line_->calls)
        for (const Line& line : code_.lines)
            if (line.definition && line.definition->of == call.of) {
                const auto before = shown_;
                wrong = passed(call, *line.definition, step);
                if (wrong) // another call is meant
                    shown_ = before;
                if (!wrong && line_->turns && step.what == clipping::What::Let)
                    turn(step, call, *line.definition);
                if (!wrong)
                    return;
            }
    if (wrong)
        throw Wrong{*wrong};
}

/// Gives the parameters that are told their values, if they are those of the arguments.
std::optional<Wrong> StepCheck::passed(const Arguments& call, const Parameters& parameters,
                                       const clipping::Step& step)
{
    std::vector<std::pair<int, double>> values;
    for (std::size_t k = 0; k < call.values.size(); ++k) {
        const int slot = parameters.variables[k];
        const auto value = told(step, slot);
        if (!value)
            continue;
        const double found = valueOf(call.values[k]);
        if (!same(found, *value))
            return Wrong{code_.names.at(slot) + " = " + text(found), text(*value)};
        values.emplace_back(slot, found);
    }
    for (const auto& [slot, value] : values)
        scope_.set(slot, value);
    return std::nullopt;
}

} // namespace app::formulas

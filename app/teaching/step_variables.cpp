// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/step_variables.h"

#include "app/teaching/code_line.h"
#include "app/teaching/sentences/code_values.h"

#include <algorithm>

namespace app {

std::vector<Variable> stepVariables(const TracedLine& tracedLine, const Narration& narration,
                                    std::size_t step)
{
    constexpr std::size_t most = 6;
    std::vector<Variable> shown;
    if (step >= narration.steps.size())
        return shown;
    const NarratedStep& narrated = narration.steps[step];
    std::ranges::copy_if(narrated.variables, std::back_inserter(shown), &Variable::changed);
    const clipping::Step unused{};
    const SentenceContext context{tracedLine, unused, nullptr, narrated.variables};
    const CodeValues values(context, {});
    for (const QString& name : namesIn(narration.code.value(narrated.line - 1))) {
        auto variable = values.of(name);
        if (!variable || std::ranges::count(shown, variable->name, &Variable::name))
            continue;
        if (!std::ranges::count(narrated.variables, variable->name, &Variable::name))
            variable->before = variable->value; // of the line or the window: it never changes
        shown.push_back(*variable);
    }
    shown.resize(std::min(shown.size(), most));
    return shown;
}

std::vector<Variable> allVariables(const TracedLine& tracedLine, const Narration& narration,
                                   std::size_t step)
{
    if (step >= narration.steps.size())
        return {};
    std::vector<Variable> all = narration.steps[step].variables;
    const auto add = [&all](const Variable& variable) {
        if (!std::ranges::count(all, variable.name, &Variable::name))
            all.push_back(variable);
    };
    const auto addGiven = [&](const char* name, double value) {
        add({.name = QLatin1StringView(name), .value = value, .before = value});
    };
    const auto& [a, b] = tracedLine.line;
    addGiven("x1", a.x), addGiven("y1", a.y), addGiven("x2", b.x), addGiven("y2", b.y);
    if (const auto& [min, max] = tracedLine.window; tracedLine.corners.empty())
        addGiven("xmin", min.x), addGiven("ymin", min.y), addGiven("xmax", max.x),
            addGiven("ymax", max.y);
    std::ranges::for_each(stepVariables(tracedLine, narration, step), add); // "xi"
    return all;
}

} // namespace app

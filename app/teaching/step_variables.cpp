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
    const auto& [line, window] = std::pair(tracedLine.line, tracedLine.window);
    for (const auto& [name, value] : {std::pair{"x1", line.a.x},
                                      {"y1", line.a.y},
                                      {"x2", line.b.x},
                                      {"y2", line.b.y},
                                      {"xmin", window.min.x},
                                      {"ymin", window.min.y},
                                      {"xmax", window.max.x},
                                      {"ymax", window.max.y}})
        if (const QString given = QLatin1StringView(name);
            !std::ranges::count(all, given, &Variable::name))
            all.push_back({.name = given, .value = value, .before = value});
    for (const Variable& variable : stepVariables(tracedLine, narration, step)) // "xi"
        if (!std::ranges::count(all, variable.name, &Variable::name))
            all.push_back(variable);
    return all;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/teaching/formulas/checker.h"

#include <algorithm>

#include "tests/app/teaching/formulas/step_check.h"

namespace app::formulas {

std::optional<Fault> Checker::check(const clipping::Segment& segment,
                                    const clipping::Window& window, const clipping::Trace& trace,
                                    const clipping::OperationCounts& operations)
{
    StepCheck run(code_, evaluated_, comparedLess_, segment, window);
    int number = 0;
    const auto fault = [&](const std::string& found, const std::string& told) {
        const bool isLine = number >= 1 && number <= int(code_.lines.size());
        return Fault{number, isLine ? code_.lines[std::size_t(number) - 1].text : std::string(),
                     run.scope().text(), found, told};
    };
    try {
        for (const clipping::Step& step : trace.steps) {
            number = clipping::lineOf(code_.labels, step.label);
            run.step(step);
        }
        run.end(operations);
        return std::nullopt;
    } catch (const Wrong& wrong) {
        return fault(wrong.found, wrong.told);
    } catch (const Unreadable& unreadable) {
        return fault(unreadable.what(), "a step");
    }
}

std::vector<Place> Checker::notEvaluated() const
{
    auto all = formulasOf(code_);
    std::erase_if(all, [&](const Place& p) { return evaluated_[p.formula->number] != 0; });
    return all;
}

std::string text(const Fault& fault)
{
    return "line " + std::to_string(fault.line) + ": " + fault.text + "\n  variables: "
           + fault.variables + "\n  found: " + fault.found + "\n  told: " + fault.told;
}

} // namespace app::formulas

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/clipping/formulas/step_check.h"

namespace formulas {

/// What a step costs occurs in its line. Conditions may end early, so that a step can cost less.
void StepCheck::cost(const clipping::Step& step)
{
    const auto& most = line_->mostOperations;
    const auto check = [&](std::uint64_t before, std::uint64_t after, std::uint64_t limit,
                           const char* what) {
        if (after - before > limit)
            throw Wrong{std::to_string(limit) + ' ' + what + " at most",
                        std::to_string(after - before)};
    };
    check(cost_.additions, step.cost.additions, most.additions, "additions");
    check(cost_.multiplications, step.cost.multiplications, most.multiplications,
          "multiplications");
    check(cost_.divisions, step.cost.divisions, most.divisions, "divisions");
    check(cost_.negations, step.cost.negations, most.negations, "negations");
    if (!line_->holds)
        check(cost_.comparisons, step.cost.comparisons, most.comparisons, "comparisons");
    cost_ = step.cost;
}

void StepCheck::end(const clipping::OperationCounts& operations) const
{
    if (operations != cost_)
        throw Wrong{"all operations are told with the last step", "more or fewer"};
}

} // namespace formulas

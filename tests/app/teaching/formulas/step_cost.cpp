// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/teaching/formulas/step_check.h"

namespace app::formulas {

/// A step costs exactly what the formulas of its line show, which it evaluates. Functions that
/// compute hide some operations, and a turned plane some changes of sign: of those the step costs
/// at most what they can cost.
void StepCheck::cost(const clipping::Step& step)
{
    const auto& most = line_->mostOperations;
    const auto check = [&](std::uint64_t before, std::uint64_t after, std::uint64_t shown,
                           std::uint64_t limit, bool hides, const char* what) {
        const std::uint64_t cost = after - before;
        if (hides ? cost > limit : cost != shown)
            throw Wrong{std::to_string(hides ? limit : shown) + ' ' + what
                            + (hides ? " at most" : ""),
                        std::to_string(cost)};
    };
    const bool computes = line_->computesInFunctions;
    check(cost_.additions, step.cost.additions, shown_.additions, most.additions, computes,
          "additions");
    check(cost_.multiplications, step.cost.multiplications, shown_.multiplications,
          most.multiplications, computes, "multiplications");
    check(cost_.divisions, step.cost.divisions, shown_.divisions, most.divisions, computes,
          "divisions");
    check(cost_.negations, step.cost.negations, shown_.negations, most.negations,
          computes || line_->turns, "negations");
    if (!line_->holds)
        check(cost_.comparisons, step.cost.comparisons, shown_.comparisons, most.comparisons,
              computes || line_->comparesLess, "comparisons");
    if (step.cost.comparisons - cost_.comparisons < shown_.comparisons)
        comparedLess_[std::size_t(line_ - code_.lines.data())] = 1;
    cost_ = step.cost;
}

void StepCheck::end(const clipping::OperationCounts& operations) const
{
    if (operations != cost_)
        throw Wrong{"all operations are told with the last step", "more or fewer"};
}

} // namespace app::formulas

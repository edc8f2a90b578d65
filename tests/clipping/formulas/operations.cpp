// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "tests/clipping/formulas/code.h"
#include "tests/clipping/formulas/vocabulary.h"

namespace formulas {

namespace {

/// What the outermost operator costs, without its operands.
clipping::OperationCounts ownCostOf(const Expression& e)
{
    switch (e.kind) {
    case Kind::Sum:
    case Kind::Difference:
        return {.additions = 1};
    case Kind::Product:
        return {.multiplications = 1};
    case Kind::Quotient:
        return {.divisions = 1};
    case Kind::Negative:
        return {.negations = 1};
    case Kind::Less:
    case Kind::Greater:
    case Kind::AtMost:
    case Kind::AtLeast:
    case Kind::Equal:
    case Kind::NotEqual:
        return {.comparisons = 1};
    case Kind::Function:
        return std::ranges::find(functions, e.name, &Function::name)->cost;
    default:
        return {};
    }
}

} // namespace

clipping::OperationCounts mostOperationsOf(const Expression& e)
{
    clipping::OperationCounts all = ownCostOf(e);
    for (const Expression& part : e.parts) {
        const auto more = mostOperationsOf(part);
        all.additions += more.additions, all.multiplications += more.multiplications;
        all.divisions += more.divisions, all.comparisons += more.comparisons;
        all.negations += more.negations;
    }
    return all;
}

} // namespace formulas

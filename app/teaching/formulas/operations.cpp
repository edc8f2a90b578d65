// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/formulas/code.h"
#include "app/teaching/formulas/evaluate.h"
#include "app/teaching/formulas/vocabulary.h"

#include <algorithm>

namespace app::formulas {

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
    for (const Expression& part : e.parts)
        add(all, mostOperationsOf(part));
    return all;
}

namespace {

/// Whether an operation on it is counted.
bool isNumber(const Expression& e, const Scope& scope)
{
    const auto is = [&](const Expression& part) { return isNumber(part, scope); };
    switch (e.kind) {
    case Kind::Name:
    case Kind::Element:
        return scope.isNumber(slotOf(e, scope));
    case Kind::Sum:
    case Kind::Difference:
    case Kind::Product:
    case Kind::Quotient:
    case Kind::Negative:
        return std::ranges::any_of(e.parts, is);
    case Kind::Choice:
        return is(e.parts[1]) || is(e.parts[2]);
    case Kind::Function:
        if (e.name == "min" || e.name == "max")
            return std::ranges::any_of(e.parts, is);
        return e.name != "outcode" && e.name != "order" && e.name != "side" && e.name != "beyond"
               && e.name != "sign" && e.name != "atEdge" && e.name != "vertical";
    default:
        return false;
    }
}

} // namespace

clipping::OperationCounts operationOf(const Expression& e, const Scope& scope)
{
    const bool counts = e.kind == Kind::Function || operatesOnNumbers(e, scope);
    return counts ? ownCostOf(e) : clipping::OperationCounts{};
}

bool operatesOnNumbers(const Expression& e, const Scope& scope)
{
    return std::ranges::any_of(e.parts,
                               [&](const Expression& part) { return isNumber(part, scope); });
}

clipping::OperationCounts mostCostOf(const Expression& function)
{
    const auto cost = ownCostOf(function);
    return cost.additions > 0 ? cost : clipping::OperationCounts{};
}

bool callsFunction(const Expression& e)
{
    return e.kind == Kind::Function || std::ranges::any_of(e.parts, callsFunction);
}

bool callsArithmetic(const Expression& e)
{
    const auto computes = [](const Expression& f) {
        return std::ranges::find(functions, f.name, &Function::name)->cost.additions > 0;
    };
    return (e.kind == Kind::Function && computes(e))
           || std::ranges::any_of(e.parts, callsArithmetic);
}

void add(clipping::OperationCounts& to, const clipping::OperationCounts& more)
{
    to.additions += more.additions, to.multiplications += more.multiplications;
    to.divisions += more.divisions, to.comparisons += more.comparisons;
    to.negations += more.negations;
}

} // namespace app::formulas

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "tests/app/teaching/formulas/step_check.h"

namespace app::formulas {

namespace {

/// Whether a variable's slot can be told, without an index that is not known yet.
bool hasSlot(const Expression& variable, const Scope& scope)
{
    return variable.kind == Kind::Name || variable.parts[0].kind == Kind::Number
           || (variable.parts[0].kind == Kind::Name
               && scope.isKnown(variable.parts[0].variables[0]));
}

/// Whether a copy is of that value.
bool gives(const Expression& copy, double value, const Scope& scope)
{
    if (copy.kind == Kind::Number)
        return same(copy.number, value);
    if (!hasSlot(copy, scope))
        return false;
    const int slot = slotOf(copy, scope);
    return scope.isKnown(slot) && same(scope.value(slot), value);
}

/// Whether an edge, one of its corners or its normal can have that coordinate.
bool isOfAnEdge(double value, const clipping::Window& w)
{
    const std::array all{w.min.x, w.min.y, w.max.x, w.max.y, -1.0, 0.0, 1.0};
    return std::ranges::find(all, value) != all.end();
}

} // namespace

/// The slot of a name as a step says it: while i is 1, x[i] is x[1], and xi is x1.
int StepCheck::slotOfTold(std::string_view name) const
{
    const std::size_t bracket = name.find('[');
    const std::string_view array = name.substr(0, bracket == name.npos ? 1 : bracket + 1);
    const std::string_view rest = name.substr(array.size());
    const bool isElement = bracket != name.npos && rest.ends_with(']');
    const std::string_view index = isElement ? rest.substr(0, rest.size() - 1) : rest;
    if (isElement || code_.loops.contains(std::string(rest)))
        if (const int i = code_.names.find(index); i != -1 && scope_.isKnown(i))
            return code_.names.find(std::string(array) + std::to_string(int(scope_.value(i)))
                                    + (isElement ? "]" : ""));
    return code_.names.find(name);
}

bool StepCheck::givesValueTo(int slot) const
{
    if (line_->turns && isGivenEnd(slot))
        return true;
    for (const Assignment& assignment : line_->assignments)
        if (hasSlot(assignment.target, scope_) && slotOf(assignment.target, scope_) == slot)
            return true;
    for (const Arguments& call : line_->calls)
        for (const Line& line : code_.lines)
            if (line.definition && line.definition->of == call.of
                && std::ranges::count(line.definition->variables, slot) != 0)
                return true;
    return false;
}

/// Values that are told with a step of another line are copies, the turn of a loop, or known.
void StepCheck::takeFromOtherLines(const clipping::Step& step)
{
    for (const clipping::NamedValue& value : step.values) {
        const std::string name(value.name);
        const int slot = slotOfTold(name);
        if (slot == -1)
            throw Wrong{"no line gives " + name + " a value", text(value.value)};
        scope_.setIsNumber(slot, value.kind == clipping::ValueKind::Number);
        if (givesValueTo(slot))
            continue;
        const bool isKnown = scope_.isKnown(slot) && same(scope_.value(slot), value.value);
        if (!isKnown && !isCopied(slot, value.value))
            throw Wrong{"neither this line nor a copy elsewhere gives " + name + " this value",
                        text(value.value)};
        scope_.set(slot, value.value);
    }
}

bool StepCheck::isCopied(int slot, double value) const
{
    return std::ranges::any_of(code_.lines, [&](const Line& line) {
        const auto is = [&](const Expression& e) { return gives(e, value, scope_); };
        if (line.loop == slot && std::ranges::any_of(line.rounds, is))
            return true;
        if (std::ranges::count(line.ofEach, slot) != 0)
            return isOfAnEdge(value, scope_.window());
        return std::ranges::any_of(line.assignments, [&](const Assignment& a) {
            return isCopy(a.value.expression) && hasSlot(a.target, scope_)
                   && slotOf(a.target, scope_) == slot && is(a.value.expression);
        });
    });
}

/// The value that a step tells of a variable, the last one if there are several.
std::optional<double> StepCheck::told(const clipping::Step& step, int slot) const
{
    for (auto value = step.values.rbegin(); value != step.values.rend(); ++value)
        if (slotOfTold(value->name) == slot)
            return value->value;
    return std::nullopt;
}

void StepCheck::nameOfLet(const clipping::Step& step) const
{
    const int slot = slotOfTold(step.name);
    if (slot == -1 || !givesValueTo(slot) || !told(step, slot))
        throw Wrong{"the line gives " + std::string(step.name) + " no value", "that it does"};
}

double StepCheck::valueOf(const Formula& formula)
{
    evaluated_[formula.number] = 1;
    return formulas::valueOf(formula.expression, scope_, &shown_);
}

int StepCheck::axisOf(int slot) const
{
    const char first = code_.names.at(slot)[0];
    return first == 'x' ? 0 : first == 'y' ? 1 : -1;
}

void StepCheck::setEnds()
{
    for (std::size_t k = 0; k < 4; ++k)
        if (code_.ends[k] != -1)
            scope_.set(code_.ends[k], ends_[k]);
}

} // namespace app::formulas

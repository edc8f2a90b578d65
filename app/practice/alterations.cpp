// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/practice/alterations.h"

#include "app/base/text.h"
#include "app/teaching/formulas/code.h"
#include "app/teaching/formulas/evaluate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

namespace app {

namespace {

using formulas::Code, formulas::Expression, formulas::Names, formulas::Scope, formulas::Unreadable;
using Operation = formulas::Kind;

/// The pseudo-code of a form, read once, because that takes a millisecond. Null if it is
/// unreadable.
const Code* codeReadOf(const Variant& variant)
{
    static std::mutex reading;
    static std::map<std::string_view, std::optional<Code>> all;
    const std::lock_guard lock(reading);
    const std::string_view text = clipping::codeOf(*variant.algorithm, variant.form);
    const auto [at, isNew] = all.try_emplace(text);
    if (isNew)
        try {
            at->second = formulas::read(text);
        } catch (const Unreadable&) {
        }
    return at->second ? &*at->second : nullptr;
}

/// The variables known when the line of a step is run.
Scope scopeAt(const MoveContext& context, const Code& code)
{
    Scope scope(code.names, context.tracedLine.line, context.tracedLine.window);
    scope.edge = context.traced().edge;
    const auto set = [&](const QString& name, double value) {
        const int slot = code.names.find(name.toStdString());
        if (slot >= 0)
            scope.set(slot, value);
    };
    const auto& variables = context.now().variables;
    const auto put = [&](const QString& name, double value) {
        set(name, value);
        const QString index = name.section(u'[', 1).chopped(name.endsWith(u']') ? 1 : 0);
        const auto known = std::ranges::find(variables, index, &Variable::name);
        if (known != variables.end()) // X[k] is X[2] while k is 2
            set(QStringLiteral("%1[%2]").arg(name.section(u'[', 0, 0)).arg(int(known->value)),
                value);
    };
    for (const Variable& variable : variables)
        if (variable.name != latin(context.planned.variable))
            put(variable.name, variable.value);
        else if (variable.before)
            put(variable.name, *variable.before);
    return scope;
}

/// The formula that the line of a step gives to a variable; null if there is none.
const Expression* formulaFor(const Code& code, std::size_t line, std::string_view name,
                             const Scope& scope)
{
    if (line >= code.lines.size())
        return nullptr;
    for (const auto& assignment : code.lines[line].assignments)
        if (code.names.at(formulas::slotOf(assignment.target, scope)) == name)
            return &assignment.value.expression;
    for (const formulas::Arguments& call : code.lines[line].calls)
        for (const formulas::Line& other : code.lines)
            for (std::size_t k = 0;
                 other.definition && other.definition->of == call.of && k < call.values.size(); ++k)
                if (code.names.at(other.definition->variables[k]) == name)
                    return &call.values[k].expression;
    return nullptr;
}

std::optional<double> valueIn(const Expression& e, const Scope& scope)
{
    try {
        return formulas::valueOf(e, scope);
    } catch (const Unreadable&) {
        return std::nullopt;
    }
}

/// A formula with names exchanged in pairs; empty if it has none of them.
std::optional<Expression>
renamed(Expression e, const Names& names,
        std::span<const std::pair<std::string_view, std::string_view>> pairs)
{
    bool found = false;
    const auto visit = [&](auto& self, Expression& part) -> void {
        if (part.kind == Operation::Name)
            for (const auto& [one, other] : pairs) {
                const std::string& name = names.at(part.variables[0]);
                const std::string_view to = name == one ? other : name == other ? one : "";
                if (const int slot = names.find(to); slot >= 0) {
                    part.variables[0] = slot, found = true;
                    break;
                }
            }
        for (Expression& operand : part.parts)
            self(self, operand);
    };
    visit(visit, e);
    return found ? std::optional(e) : std::nullopt;
}

/// The same formula with the operands of its first operation of a kind exchanged.
std::optional<Expression> exchanged(Expression e, Operation kind)
{
    bool found = false;
    const auto visit = [&](auto& self, Expression& part) -> void {
        if (!found && part.kind == kind) {
            std::swap(part.parts[0], part.parts[1]), found = true;
            return;
        }
        for (Expression& operand : part.parts)
            self(self, operand);
    };
    visit(visit, e);
    return found ? std::optional(e) : std::nullopt;
}

using Pair = std::pair<std::string_view, std::string_view>;
constexpr std::array sides{Pair{"xmin", "xmax"}, Pair{"ymin", "ymax"}};
constexpr std::array ends{Pair{"x1", "x2"}, Pair{"y1", "y2"}, Pair{"x[1]", "x[2]"},
                          Pair{"y[1]", "y[2]"}};
constexpr std::array axes{Pair{"x1", "y1"},     Pair{"x2", "y2"},     Pair{"dx", "dy"},
                          Pair{"xmin", "ymin"}, Pair{"xmax", "ymax"}, Pair{"xi", "yi"},
                          Pair{"nx", "ny"},     Pair{"xv", "yv"}};

} // namespace

std::optional<std::vector<Alteration>> alterationsOf(const MoveContext& context)
{
    const auto code = codeReadOf(context.tracedLine.variant);
    const auto& values = context.traced().values;
    const auto told =
        std::ranges::find(values, context.planned.variable, &clipping::NamedValue::name);
    if (!code || told == values.end())
        return std::nullopt;
    const Scope scope = scopeAt(context, *code);
    const Expression* formula = nullptr;
    try {
        formula = formulaFor(*code, std::size_t(context.now().line) - 1, told->name, scope);
    } catch (const Unreadable&) { // an index is not known yet
    }
    const auto value = formula ? valueIn(*formula, scope) : std::nullopt;
    if (!value || !formulas::same(*value, told->value))
        return std::nullopt;
    std::vector<Alteration> all;
    const auto add = [&](std::string_view kind, const std::optional<Expression>& e,
                         const QString& hint) {
        if (const auto wrong = e ? valueIn(*e, scope) : std::nullopt)
            all.push_back({kind, *wrong, hint});
    };
    all.push_back({"sign", -*value,
                   Text::tr("The sign is wrong. Mind the order of a difference, and every minus "
                            "sign of the formula.")});
    add("quotient", exchanged(*formula, Operation::Quotient),
        Text::tr("Divided the wrong way round: what stands behind the stroke is the divisor."));
    if (told->name == "r" || told->name == "t")
        all.push_back({"other-end", 1 - *value,
                       Text::tr("This is measured from End 2. The value is 0 at End 1 and 1 at End "
                                "2.")});
    add("opposite", renamed(*formula, code->names, sides),
        Text::tr("That is the value at the opposite edge. Which of min and max stands in the "
                 "line?"));
    add("axes", renamed(*formula, code->names, axes),
        Text::tr("x and y are exchanged. Which axis does the line use?"));
    add("ends", renamed(*formula, code->names, ends),
        Text::tr("The ends are exchanged. Which coordinates stand in the line?"));
    return all;
}

} // namespace app

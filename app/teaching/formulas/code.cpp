// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/formulas/code.h"

#include "app/teaching/formulas/line_reader.h"

#include <algorithm>

namespace app::formulas {

namespace {

std::set<std::string> loopsIn(const std::vector<clipping::CodeLine>& lines)
{
    std::set<std::string> loops;
    for (const clipping::CodeLine& line : lines)
        if (const auto tokens = tokensOf(line.text);
            tokens.size() > 2 && tokens[0].text == "for" && tokens[2].text == "=")
            loops.emplace(tokens[1].text);
    return loops;
}

/// The names of the ends, if all lines that accept something say the same names.
std::array<int, 4> endsOf(const Code& code)
{
    std::array<int, 4> ends{-1, -1, -1, -1};
    for (const Line& line : code.lines) {
        std::array<int, 4> here{-1, -1, -1, -1};
        for (std::size_t k = 0; k < line.accepted.size(); ++k) {
            const Expression& e = line.accepted[k].expression;
            const bool isConstant = e.kind == Kind::Element && e.parts[0].kind == Kind::Number;
            here[k] = e.kind == Kind::Name ? e.variables[0]
                      : isConstant         ? e.variables.at(std::size_t(e.parts[0].number))
                                           : -1;
        }
        if (std::ranges::count(here, -1) != 0)
            continue;
        if (ends[0] != -1 && ends != here)
            throw Unreadable("Two lines accept ends of different names");
        ends = here;
    }
    return ends;
}

/// Whether a procedure that takes the window is given other variables than its own, though the
/// plane is not turned for it: no step tells such a call.
bool isGivenOthers(const Arguments& call, const Parameters& parameters)
{
    const auto isOwn = [](const Formula& argument, int parameter) {
        return argument.expression.kind == Kind::Name
               && argument.expression.variables[0] == parameter;
    };
    return std::ranges::any_of(parameters.variables, isEdge)
           && !std::ranges::equal(call.values, parameters.variables, isOwn);
}

void checkCalls(const Code& code)
{
    const auto defines = [&](const Arguments& call) {
        return std::ranges::any_of(code.lines, [&](const Line& line) {
            return line.definition && line.definition->of == call.of
                   && line.definition->variables.size() == call.values.size();
        });
    };
    for (const Line& line : code.lines)
        for (const Arguments& call : line.calls)
            if (!defines(call))
                throw Unreadable("No line defines " + call.of + " of "
                                 + std::to_string(call.values.size()) + " parameters");
    for (const Line& line : code.lines)
        for (const Line& other : code.lines)
            for (const Arguments& call : line.calls)
                if (!line.turns && other.definition && other.definition->of == call.of
                    && isGivenOthers(call, *other.definition))
                    throw Unreadable("The call of " + call.of
                                     + " neither hands on what there is "
                                       "nor turns the plane");
}

bool hasCall(const Expression& e)
{
    return e.kind == Kind::Call || std::ranges::any_of(e.parts, hasCall);
}

} // namespace

std::string withoutLabels(std::string_view code)
{
    std::string text;
    for (const clipping::CodeLine& line : clipping::linesOf(code))
        (text += line.text) += '\n';
    return text;
}

Code read(std::string_view text)
{
    Code code;
    code.labels = clipping::linesOf(text);
    code.loops = loopsIn(code.labels);
    for (const auto& [line, labels] : code.labels)
        try {
            code.lines.push_back(LineReader(code, line, code.loops).read());
        } catch (const Unreadable& e) {
            throw Unreadable("Line " + std::to_string(code.lines.size() + 1) + ", \""
                             + std::string(line) + "\": " + e.what());
        }
    code.ends = endsOf(code);
    checkCalls(code);
    return code;
}

std::vector<Place> formulasOf(const Code& code)
{
    std::vector<Place> all;
    for (std::size_t i = 0; i < code.lines.size(); ++i) {
        const auto add = [&](const Formula& formula) {
            if (!isCopy(formula.expression) && !hasCall(formula.expression))
                all.push_back({i + 1, &formula});
        };
        const Line& line = code.lines[i];
        if (line.condition)
            add(*line.condition);
        for (const Assignment& assignment : line.assignments)
            add(assignment.value);
        for (const Arguments& call : line.calls)
            std::ranges::for_each(call.values, add);
        std::ranges::for_each(line.accepted, add);
    }
    return all;
}

} // namespace app::formulas

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/formulas/line_reader.h"

#include <algorithm>

namespace app::formulas {

namespace {

bool isNegativeEdge(const Expression& argument)
{
    return argument.kind == Kind::Negative && argument.parts[0].kind == Kind::Name
           && isEdge(argument.parts[0].variables[0]);
}

} // namespace

LineReader::LineReader(Code& code, std::string_view text, const std::set<std::string>& loops)
    : code_(code), in_(text, code.names, loops), line_{.text = std::string(text)}
{
}

Line LineReader::read()
{
    if (definitionIsNext())
        definition();
    else
        afterKeyword();
    if (!in_.atEnd())
        in_.fail("The end of the line");
    return std::move(line_);
}

/// What a line begins with, and after a colon what is done then.
void LineReader::afterKeyword()
{
    if (in_.takes("repeat"))
        return;
    if (in_.takes("for"))
        return forLine();
    const bool otherwise = in_.takes("else");
    if (in_.takes("if") || (!otherwise && (in_.takes("while") || in_.takes("until"))))
        condition();
    else if (!otherwise)
        return statement();
    if (in_.takes(":"))
        statement();
}

void LineReader::condition() { line_.condition = formula(in_.expression()); }

/// for i = 1, 2; or for each edge, with names.
void LineReader::forLine()
{
    if (in_.takes("each")) {
        for (const std::string& word : in_.rest())
            line_.ofEach.push_back(code_.names.slotOf(word));
        return;
    }
    line_.loop = code_.names.slotOf(in_.word());
    in_.expect("=");
    line_.rounds = in_.list();
}

/// accept, or accept the line from A, B to C, D.
void LineReader::acceptLine()
{
    line_.accepts = true;
    if (in_.atEnd())
        return;
    for (const char* word : {"the", "line", "from"})
        in_.expect(word);
    for (const char* between : {",", "to", ",", ""}) {
        line_.accepted.push_back(formula(in_.expression()));
        if (*between)
            in_.expect(between);
    }
}

void LineReader::statement()
{
    if (in_.takes("accept"))
        return acceptLine();
    if (in_.takes("reject"))
        return void(line_.rejects = true);
    if (in_.takes("return"))
        return;
    if (in_.takes("hold"))
        return line_.holds = true, void(in_.rest());
    if (in_.takes("give")) {
        in_.expect("up");
        return line_.givesUp = true, void(in_.rest());
    }
    line_.turns = in_.takes("turn") || in_.takes("mirror");
    if (!in_.sees("(", 1) && !line_.turns)
        return assignments();
    const Formula call = formula(in_.expression());
    if (call.expression.kind != Kind::Call)
        in_.fail("A statement");
    if (line_.turns) // an axis that changes its sign does so at two edges and at both ends
        line_.mostOperations.negations +=
            std::uint64_t(std::ranges::count_if(call.expression.parts, isNegativeEdge));
}

/// Whether the line is f(p, q): and defines f.
bool LineReader::definitionIsNext() const
{
    std::size_t i = 2;
    while (!in_.sees(")", i) && i < 20)
        ++i;
    return in_.sees("(", 1) && in_.sees(":", i + 1) && !in_.sees("if") && !in_.sees("while")
           && !in_.sees("until");
}

void LineReader::definition()
{
    line_.definition = Parameters{in_.word(), {}};
    in_.expect("(");
    while (!in_.takes(")")) {
        line_.definition->variables.push_back(code_.names.slotOf(in_.word()));
        in_.takes(",");
    }
    in_.expect(":");
    if (!in_.atEnd())
        afterKeyword();
}

void LineReader::assignments()
{
    do {
        Expression target = in_.variable();
        if (target.kind == Kind::Number)
            in_.fail("A variable");
        in_.expect("=");
        line_.assignments.push_back({std::move(target), formula(in_.expression())});
    } while (in_.takes(",") && !in_.takes("return"));
}

Formula LineReader::formula(Expression e)
{
    findCalls(e);
    add(line_.mostOperations, mostOperationsOf(e));
    line_.comparesInFunctions |= callsFunction(e);
    line_.computesInFunctions |= callsArithmetic(e);
    return {std::move(e), code_.formulas++};
}

void LineReader::findCalls(const Expression& e)
{
    for (const Expression& part : e.parts)
        findCalls(part);
    if (e.kind != Kind::Call)
        return;
    Arguments call{e.name, {}};
    for (const Expression& argument : e.parts)
        call.values.push_back({argument, code_.formulas++});
    line_.calls.push_back(std::move(call));
}

} // namespace app::formulas

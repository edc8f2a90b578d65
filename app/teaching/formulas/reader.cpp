// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/formulas/reader.h"

#include "app/teaching/formulas/vocabulary.h"

#include <cstdlib>

namespace app::formulas {

Expression Reader::expression()
{
    Expression condition = level(0);
    if (!takes("?"))
        return condition;
    Expression choice{.kind = Kind::Choice, .parts = {std::move(condition), expression()}};
    expect(":");
    choice.parts.push_back(expression());
    return choice;
}

std::vector<Expression> Reader::list()
{
    std::vector<Expression> all{expression()};
    while (takes(","))
        all.push_back(expression());
    return all;
}

Expression Reader::level(std::size_t n)
{
    if (n == tightest)
        return unary();
    if (n == levelOfNot && takes("not"))
        return {.kind = Kind::Not, .parts = {level(n)}};
    Expression left = level(n + 1);
    for (;;) {
        const Operator* found = nullptr;
        for (const Operator& o : operators)
            if (o.level == n && sees(o.text))
                found = &o;
        if (!found)
            return left;
        next();
        left = {.kind = found->kind, .parts = {std::move(left), level(n + 1)}};
        if (n == levelOfComparisons)
            return left; // a < b < c is none
    }
}

Expression Reader::unary()
{
    if (takes("-"))
        return {.kind = Kind::Negative, .parts = {unary()}};
    if (takes("~"))
        return {.kind = Kind::Complement, .parts = {unary()}};
    return primary();
}

Expression Reader::primary()
{
    if (takes("(")) {
        Expression inner = expression();
        expect(")");
        return inner;
    }
    if (seesNumber())
        return number();
    if (!sees("(", 1))
        return variable();
    Expression call{.kind = Kind::Call, .name = word()};
    expect("(");
    if (!sees(")"))
        call.parts = list();
    expect(")");
    for (const Function& f : functions)
        if (f.name == call.name) {
            call.kind = Kind::Function;
            if (call.parts.size() != f.arguments)
                throw Unreadable(call.name + " takes " + std::to_string(f.arguments)
                                 + " arguments");
        }
    return call;
}

/// Four digits of 0 and 1 are the bits of an outcode.
Expression Reader::number()
{
    const std::string text(next().text);
    const bool bits = text.size() == 4 && text.find_first_not_of("01") == std::string::npos;
    return {.number = bits ? double(std::strtoul(text.c_str(), nullptr, 2))
                           : std::strtod(text.c_str(), nullptr)};
}

Expression Reader::variable()
{
    const std::string name = word();
    for (const Constant& constant : constants)
        if (constant.name == name)
            return {.number = constant.value};
    const auto elements = [&](const std::string& before, const std::string& after, Expression i) {
        Expression e{.kind = Kind::Element, .parts = {std::move(i)}};
        for (int k = 0; k < 16; ++k) {
            std::string element = before;
            element.append(std::to_string(k)).append(after);
            e.variables.push_back(names_.slotOf(element));
        }
        return e;
    };
    if (takes("[")) {
        Expression e = elements(name + "[", "]", expression());
        expect("]");
        return e;
    }
    if (name.size() == 2 && (name[0] == 'x' || name[0] == 'y') && loops_.contains(name.substr(1)))
        return elements(name.substr(0, 1), "",
                        {.kind = Kind::Name, .variables = {names_.slotOf(name.substr(1))}});
    return {.kind = Kind::Name, .variables = {names_.slotOf(name)}};
}

} // namespace app::formulas

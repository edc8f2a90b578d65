// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/supports.h"

#include "app/formats/svg/property.h"
#include "app/formats/svg/scanner.h"
#include "app/formats/svg/selector.h"

#include <algorithm>

namespace app::svg {
namespace {

using Answer = std::optional<bool>;
constexpr int mostBrackets = 20; // brackets in brackets

Answer conditionHolds(std::string_view text, int depth);

// "fill: red", from between brackets.
Answer declarationHolds(std::string_view text)
{
    const auto colon = text.find(':');
    if (colon == text.npos)
        return std::nullopt;
    const std::string name = plainName(trimmed(text.substr(0, colon)));
    const auto value = trimmed(text.substr(colon + 1));
    if (name.starts_with("--"))
        return true;
    if (const Property* property = findProperty(name)) {
        Properties scratch;
        return property->set(scratch, value, {property->name, Lengths(), true})
                   ? Answer(true)
                   : std::nullopt; // other programs may understand it
    }
    const bool isKnown =
        hasNoEffect(name) || std::ranges::count(lostProperties(), name, &LostProperty::name) > 0;
    return isKnown ? Answer(true) : std::nullopt;
}

// The brackets at the start of a text, with a function's name before them; taken from it.
std::string_view takeBrackets(std::string_view& text)
{
    int depth = 0;
    for (std::size_t i = text.find('('); i < text.size(); ++i) {
        depth += (text[i] == '(') - (text[i] == ')');
        if (depth == 0) {
            const auto taken = text.substr(0, i + 1);
            text = trimmed(text.substr(i + 1));
            return taken;
        }
    }
    return {};
}

bool takeKeyword(std::string_view& text, std::string_view word)
{
    if (!equalsIgnoringCase(text.substr(0, word.size()), word)
        || text.find_first_of(" \t\r\n\f(", word.size()) != word.size())
        return false;
    text = trimmed(text.substr(word.size()));
    return true;
}

// One part of a condition, taken from the start of the text.
Answer takeHolds(std::string_view& text, int depth)
{
    const auto one = takeBrackets(text);
    const auto open = one.find('(');
    if (one.empty())
        return std::nullopt;
    const auto inside = trimmed(one.substr(open + 1, one.size() - open - 2));
    if (open == 0) {
        const auto nested = conditionHolds(inside, depth + 1);
        return nested ? nested : declarationHolds(inside);
    }
    if (equalsIgnoringCase(one.substr(0, open), "selector"))
        return parseSelector(inside) ? Answer(true) : std::nullopt;
    return std::nullopt;
}

Answer conditionHolds(std::string_view text, int depth)
{
    text = trimmed(text);
    if (depth > mostBrackets || text.empty())
        return std::nullopt;
    if (takeKeyword(text, "not")) {
        const auto one = takeHolds(text, depth);
        return one && text.empty() ? Answer(!*one) : std::nullopt;
    }
    if (text.front() != '(' && !equalsIgnoringCase(text.substr(0, 9), "selector("))
        return std::nullopt;
    auto result = takeHolds(text, depth);
    while (result && !text.empty()) {
        const bool both = takeKeyword(text, "and");
        if (!both && !takeKeyword(text, "or"))
            return std::nullopt;
        const auto next = takeHolds(text, depth);
        if (!next)
            return std::nullopt;
        result = both ? *result && *next : *result || *next;
    }
    return result;
}

} // namespace

std::optional<bool> isSupported(std::string_view condition) { return conditionHolds(condition, 0); }

} // namespace app::svg

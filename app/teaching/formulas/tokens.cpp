// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/formulas/tokens.h"

#include <algorithm>
#include <array>

namespace app::formulas {

namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// How many characters the token that begins a text has.
std::size_t lengthOf(std::string_view text)
{
    static constexpr std::array<std::string_view, 4> pairs{"<=", ">=", "==", "!="};
    const auto firstNot = [&](auto belongs) {
        return std::size_t(std::ranges::find_if_not(text, belongs) - text.begin());
    };
    if (isLetter(text[0]))
        return firstNot([](char c) { return isLetter(c) || isDigit(c); });
    if (isDigit(text[0]))
        return firstNot([](char c) { return isDigit(c) || c == '.'; });
    return std::ranges::find(pairs, text.substr(0, 2)) != pairs.end() ? 2 : 1;
}

} // namespace

bool isWord(const Token& token) { return isLetter(token.text[0]); }
bool isNumber(const Token& token) { return isDigit(token.text[0]); }

std::vector<Token> tokensOf(std::string_view line)
{
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t length = line[at] == ' ' ? 1 : lengthOf(line.substr(at));
        if (line[at] != ' ')
            tokens.push_back({line.substr(at, length), at});
        at += length;
    }
    return tokens;
}

} // namespace app::formulas

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace app::formulas {

/// A word, a number or a sign of a line, and where it begins.
struct Token {
    std::string_view text;
    std::size_t at;
};

bool isWord(const Token& token);   ///< begins with a letter
bool isNumber(const Token& token); ///< begins with a digit

/// The tokens of a line; a character of no meaning is a token of its own.
std::vector<Token> tokensOf(std::string_view line);

} // namespace app::formulas

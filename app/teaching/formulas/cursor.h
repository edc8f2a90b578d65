// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/formulas/tokens.h"

#include <string>

namespace app::formulas {

/// A place among the tokens of a line, which goes from left to right.
class Cursor {
public:
    explicit Cursor(std::string_view line) : tokens_(tokensOf(line)) {}

    bool atEnd() const { return at_ == tokens_.size(); }
    bool sees(std::string_view text, std::size_t further = 0) const;
    bool seesNumber() const { return !atEnd() && isNumber(tokens_[at_]); }
    bool takes(std::string_view text); ///< goes on if that is the next token
    void expect(std::string_view text);
    std::string word();              ///< a name, which must be next
    std::vector<std::string> rest(); ///< the words up to the end
    const Token& next() { return tokens_[at_++]; }
    /// Throws Unreadable, which says where `wanted` is missing.
    [[noreturn]] void fail(const std::string& wanted) const;

private:
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
};

} // namespace app::formulas

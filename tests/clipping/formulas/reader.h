// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "tests/clipping/formulas/expression.h"
#include "tests/clipping/formulas/tokens.h"

namespace formulas {

/// Reads the formulas of a line from left to right. What binds tightest first: unary - and ~; * /;
/// + -; &; |; comparisons; not; and; or; c ? a : b.
class Reader {
public:
    /// `loops`: the variables of the code's `for` lines. xi is the x that was given of end i.
    Reader(std::string_view line, Names& names, const std::set<std::string>& loops)
        : tokens_(tokensOf(line)), names_(names), loops_(loops)
    {
    }

    Expression expression();        ///< with everything
    std::vector<Expression> list(); ///< expressions between commas
    Expression variable();          ///< x1, x[i]

    bool atEnd() const { return at_ == tokens_.size(); }
    bool sees(std::string_view text, std::size_t further = 0) const;
    bool takes(std::string_view text); ///< goes on if that is the next token
    void expect(std::string_view text);
    std::string word();              ///< a name, which must be next
    std::vector<std::string> rest(); ///< the words up to the end
    [[noreturn]] void fail(const std::string& wanted) const;

private:
    Expression level(std::size_t n);
    Expression unary();
    Expression primary();
    Expression number();

    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    Names& names_;
    const std::set<std::string>& loops_;
};

} // namespace formulas

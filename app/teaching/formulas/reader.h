// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/formulas/cursor.h"
#include "app/teaching/formulas/expression.h"

#include <set>

namespace app::formulas {

/// Reads the formulas of a line from left to right. What binds tightest first: unary - and ~; * /;
/// + -; &; |; comparisons; not; and; or; c ? a : b.
class Reader : public Cursor {
public:
    /// `loops`: the variables of the code's `for` lines. xi is the x that was given of end i.
    Reader(std::string_view line, Names& names, const std::set<std::string>& loops)
        : Cursor(line), names_(names), loops_(loops)
    {
    }

    Expression expression();        ///< with everything
    std::vector<Expression> list(); ///< expressions between commas
    Expression variable();          ///< x1, x[i]

private:
    Expression level(std::size_t n);
    Expression unary();
    Expression primary();
    Expression number();

    Names& names_;
    const std::set<std::string>& loops_;
};

} // namespace app::formulas

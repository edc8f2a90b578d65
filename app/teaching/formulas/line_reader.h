// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/formulas/code.h"
#include "app/teaching/formulas/reader.h"

namespace app::formulas {

/// Reads the lines of a code, one after another.
class LineReader {
public:
    /// `loops`: the variables of the code's `for` lines.
    LineReader(Code& code, std::string_view text, const std::set<std::string>& loops);
    Line read();

private:
    void afterKeyword();
    void condition();
    void forLine();
    void acceptLine();
    void statement();
    bool definitionIsNext() const;
    void definition();
    void assignments();
    Formula formula(Expression e);
    void findCalls(const Expression& e);

    Code& code_;
    Reader in_;
    Line line_;
};

} // namespace app::formulas

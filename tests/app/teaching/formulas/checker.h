// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/formulas/code.h"
#include "app/teaching/formulas/evaluate.h"
#include "clipping/trace.h"

namespace app::formulas {

/// Where a step says something else than the line that it lights.
struct Fault {
    int line;              ///< from 1
    std::string text;      ///< the line's
    std::string variables; ///< what was known
    std::string found;     ///< by the formula, or what is wrong
    std::string told;      ///< by the step
};
std::string text(const Fault& fault); ///< in several lines

/// Follows a run through its pseudo-code, and evaluates every line that is lit.
class Checker {
public:
    explicit Checker(const Code& code)
        : code_(code), evaluated_(code.formulas), comparedLess_(code.lines.size())
    {
    }

    /// The first fault of a run. `operations`: what the run costs in all.
    std::optional<Fault> check(const clipping::Segment& segment, const clipping::Window& window,
                               const clipping::Trace& trace,
                               const clipping::OperationCounts& operations);

    /// The formulas that no run so far has evaluated.
    std::vector<Place> notEvaluated() const;
    /// Whether a run needed fewer comparisons than a line shows; `line` from 0.
    bool comparedLess(std::size_t line) const { return comparedLess_[line] != 0; }

private:
    const Code& code_;
    std::vector<char> evaluated_, comparedLess_;
};

} // namespace app::formulas

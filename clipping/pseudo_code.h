// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/abi.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

// A pseudo-code (`codeOf` in algorithm.h) is one text. Each line may end with two spaces, `#` and
// the labels, separated by spaces, that the steps of a trace name:
//
//     if x1 < xmin  #left

namespace CLEARCUT_API clipping {

/// A line of pseudo-code.
struct CodeLine {
    std::string_view text;   ///< for display; two spaces of indentation a level
    std::string_view labels; ///< separated by spaces; empty: no step names this line

    /// Whether a step with this label is at this line. false for an empty label.
    constexpr bool has(std::string_view label) const
    {
        for (std::string_view rest = labels; !rest.empty();) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            if (rest.substr(0, end) == label)
                return true;
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        return false;
    }
};

/// The lines of a pseudo-code.
constexpr std::vector<CodeLine> linesOf(std::string_view code)
{
    std::vector<CodeLine> lines;
    while (!code.empty()) {
        const std::string_view line = code.substr(0, code.find('\n'));
        const std::size_t end = std::min(line.find("  #"), line.size());
        lines.push_back({line.substr(0, end), line.substr(std::min(end + 3, line.size()))});
        code.remove_prefix(std::min(line.size() + 1, code.size()));
    }
    return lines;
}

/// The number of the line with a label, from 1; 0 if no line has it.
constexpr int lineOf(const std::vector<CodeLine>& lines, std::string_view label)
{
    const auto has = [&](const CodeLine& line) { return line.has(label); };
    const auto at = std::find_if(lines.begin(), lines.end(), has);
    return at == lines.end() ? 0 : static_cast<int>(at - lines.begin()) + 1;
}

} // namespace clipping

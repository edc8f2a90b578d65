// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/teaching/formulas/alterations.h"

#include "app/teaching/formulas/code.h"
#include "app/teaching/formulas/tokens.h"

#include <algorithm>
#include <array>

namespace app::formulas {

namespace {

struct Exchange {
    std::string_view from, to;
};
constexpr std::array exchanges{
    Exchange{"+", "-"},       Exchange{"-", "+"},        Exchange{"*", "/"},
    Exchange{"/", "*"},       Exchange{"<", ">"},        Exchange{">", "<"},
    Exchange{"<", "<="},      Exchange{">", ">="},       Exchange{"<=", "<"},
    Exchange{">=", ">"},      Exchange{"==", "!="},      Exchange{"!=", "=="},
    Exchange{"xmin", "xmax"}, Exchange{"xmax", "xmin"},  Exchange{"ymin", "ymax"},
    Exchange{"ymax", "ymin"}, Exchange{"x1", "x2"},      Exchange{"x2", "x1"},
    Exchange{"y1", "y2"},     Exchange{"y2", "y1"},      Exchange{"xi", "yi"},
    Exchange{"yi", "xi"},     Exchange{"dx", "dy"},      Exchange{"dy", "dx"},
    Exchange{"and", "or"},    Exchange{"or", "and"},     Exchange{"&", "|"},
    Exchange{"|", "&"},       Exchange{"LEFT", "RIGHT"}, Exchange{"RIGHT", "LEFT"},
    Exchange{"TOP", "LEFT"},  Exchange{"BOTTOM", "TOP"}, Exchange{"min", "max"},
    Exchange{"max", "min"},
};

bool reads(const std::string& code)
{
    try {
        return !read(code).lines.empty();
    } catch (const Unreadable&) {
        return false;
    }
}

struct Position {
    std::size_t begin, end; ///< characters of the code
};

/// Where the lines are that have a formula.
std::vector<Position> linesWithFormulas(std::string_view code)
{
    const Code parsed = read(code);
    std::vector<Position> all;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < parsed.lines.size(); ++i) {
        const std::size_t end = begin + parsed.lines[i].text.size();
        if (std::ranges::any_of(formulasOf(parsed), [&](auto& p) { return p.line == i + 1; }))
            all.push_back({begin, end});
        begin = end + 1;
    }
    return all;
}

} // namespace

std::vector<Altered> alterationsOf(std::string_view code)
{
    std::vector<Altered> all;
    for (const Position& p : linesWithFormulas(code)) {
        const std::string_view line = code.substr(p.begin, p.end - p.begin);
        const std::size_t indentation = line.find_first_not_of(' ');
        const auto add = [&](const std::string& change, std::string altered) {
            if (reads(altered))
                all.push_back({std::string(line.substr(indentation)), change, std::move(altered)});
        };
        for (const Token& token : tokensOf(line))
            for (const auto& [from, to] : exchanges)
                if (token.text == from)
                    add(std::string(to) + " for " + std::string(from) + " at column "
                            + std::to_string(token.at - indentation + 1),
                        std::string(code).replace(p.begin + token.at, from.size(), to));
        const std::string_view next = code.substr(std::min(p.end + 1, code.size()));
        const std::string_view after = next.substr(0, next.find('\n'));
        if (!after.empty() && after != line)
            add("exchanged with the next line",
                std::string(code).replace(p.begin, line.size() + 1 + after.size(),
                                          std::string(after) + '\n' + std::string(line)));
    }
    return all;
}

} // namespace app::formulas

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/wkt.h"

#include "app/base/csv_text.h"
#include "app/base/text.h"
#include "app/formats/csv/dialect.h"

#include <algorithm>

namespace app::csv {
namespace {

constexpr std::string_view oneLineString = "LINESTRING", manyLines = "MULTILINESTRING";

/// Reads a text from its beginning.
class WktText {
public:
    WktText(std::string_view text, std::size_t line) : rest_(text), line_(line) { skipBlanks(); }

    /// The next word in capital letters; empty: there is none.
    std::string word()
    {
        std::string word;
        for (; !rest_.empty() && isLetter(rest_.front()); rest_.remove_prefix(1))
            word += char(rest_.front() & ~0x20);
        skipBlanks();
        return word;
    }

    bool take(char c)
    {
        const bool is = !rest_.empty() && rest_.front() == c;
        if (is)
            rest_.remove_prefix(1);
        skipBlanks();
        return is;
    }

    void need(char c)
    {
        if (!take(c))
            refuse();
    }

    bool atEnd() const { return rest_.empty(); }

    double number()
    {
        const auto length = std::min(rest_.find_first_of(" \t,()"), rest_.size());
        const auto number = coordinateOf(rest_.substr(0, length), Dialect());
        if (!number)
            refuse();
        rest_.remove_prefix(length);
        skipBlanks();
        return *number;
    }

    [[noreturn]] void refuse() const
    {
        throw Refused{line_, Text::tr("has a geometry that is no LINESTRING or MULTILINESTRING.")};
    }

private:
    static bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
    void skipBlanks()
    {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
    }

    std::string_view rest_;
    std::size_t line_;
};

/// "(1 2, 3 4)"; z and m are left out.
Subpath lineOf(WktText& text)
{
    const auto point = [&] {
        Point p;
        p.x = text.number();
        p.y = text.number();
        while (!text.atEnd() && !text.take(',')) {
            if (text.take(')'))
                return std::pair(p, true);
            text.number();
        }
        return std::pair(p, false);
    };
    text.need('(');
    auto [start, isLast] = point();
    Subpath path{start, {}, false};
    while (!isLast) {
        Point next;
        std::tie(next, isLast) = point();
        path.segments.push_back({next});
    }
    return path;
}

} // namespace

bool isWkt(std::string_view field)
{
    const std::string word = WktText(trimmed(field), 0).word();
    return word == oneLineString || word == manyLines;
}

std::vector<Subpath> linesOfWkt(std::string_view field, std::size_t line)
{
    WktText text(trimmed(field), line);
    const std::string kind = text.word();
    if (kind != oneLineString && kind != manyLines)
        text.refuse();
    std::string more = text.word();
    if (more == "Z" || more == "M" || more == "ZM")
        more = text.word();
    std::vector<Subpath> lines;
    if (more == "EMPTY" && text.atEnd())
        return lines;
    if (kind == oneLineString) {
        lines.push_back(lineOf(text));
    } else {
        text.need('(');
        do
            lines.push_back(lineOf(text));
        while (text.take(','));
        text.need(')');
    }
    if (!more.empty() || !text.atEnd())
        text.refuse();
    return lines;
}

} // namespace app::csv

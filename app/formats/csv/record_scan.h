// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace app::csv {

/// Finds the ends of records and lines in a text that may end in the middle of a record.
class RecordScan {
public:
    static constexpr std::size_t unknown = ~std::size_t(0); ///< more text is needed

    RecordScan(std::string_view text, bool ended)
        : text_(text), ended_(ended), plain_(text.find('"') == std::string_view::npos
                                             && text.find('\r') == std::string_view::npos)
    {
    }

    std::size_t lines() const { return lines_; }
    char at(std::size_t i) const { return text_[i]; }
    bool isEnd(std::size_t i) const { return i == text_.size(); }

    /// Where the line ends; `unknown` if that is not known yet.
    std::size_t endOfLine(std::size_t from) const
    {
        const std::size_t end = plain_ ? text_.find('\n', from) : text_.find_first_of("\r\n", from);
        return end != std::string_view::npos ? end : ended_ ? text_.size() : unknown;
    }

    /// Where the record ends: at the end of a line, but not in quotation marks.
    std::size_t endOfRecord(std::size_t from)
    {
        if (plain_)
            return endOfLine(from);
        for (std::size_t i = from;;) {
            if (i < text_.size() && text_[i] == '"')
                i = afterQuotes(i + 1);
            i = i == unknown ? unknown : text_.find_first_of(",\r\n", i);
            if (i >= text_.size())
                return ended_ ? text_.size() : unknown;
            if (text_[i++] != ',')
                return i - 1;
        }
    }

    /// Skips LF, CR LF or a lone CR, if there is one; `unknown` if that is not known yet.
    std::size_t afterBreak(std::size_t end)
    {
        if (end < text_.size() && text_[end] == '\r') {
            if (++end == text_.size() && !ended_)
                return unknown;
            lines_ += end == text_.size() || text_[end] != '\n';
        }
        if (end == text_.size() || text_[end] != '\n')
            return end;
        ++lines_;
        return end + 1;
    }

private:
    std::size_t afterQuotes(std::size_t from)
    {
        for (std::size_t i = from;; i += 2) { // a doubled mark is a part of the field
            const std::size_t mark = text_.find('"', i);
            if (mark == std::string_view::npos || (mark + 1 == text_.size() && !ended_))
                return unknown;
            if (mark + 1 == text_.size() || text_[mark + 1] != '"') {
                lines_ += std::size_t(std::ranges::count(text_.substr(from, mark - from), '\n'));
                return mark + 1;
            }
            i = mark;
        }
    }

    std::string_view text_;
    bool ended_, plain_;
    std::size_t lines_ = 0;
};

} // namespace app::csv

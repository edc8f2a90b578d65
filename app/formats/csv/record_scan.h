// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace app::csv {

/// Finds the ends of records and lines in a text that may end in the middle of a record, and then
/// goes on where it stopped. Each byte is scanned once, or twice beside a line break.
class RecordScan {
public:
    static constexpr std::size_t unknown = ~std::size_t(0); ///< more text is needed

    /// The characters between fields.
    void setSeparators(std::string_view separators)
    {
        separators_ = separators;
        ends_ = separators_ + "\r\n";
    }

    /// Continues with a longer text. It begins with the record whose end was unknown, if any.
    void continueIn(std::string_view text, bool ended)
    {
        text_ = text;
        ended_ = ended;
        lines_ = 0;
        const std::string_view rest = text.substr(scanned_);
        plain_ = state_ != State::Quoted && rest.find('"') == std::string_view::npos
                 && rest.find('\r') == std::string_view::npos;
    }

    std::size_t lines() const { return lines_; } ///< line breaks in this text so far
    bool isQuoted() const { return state_ == State::Quoted; }
    char at(std::size_t i) const { return text_[i]; }
    bool isEnd(std::size_t i) const { return i == text_.size(); }

    /// Where the line ends; `unknown` if that is not known yet.
    std::size_t endOfLine(std::size_t from) const
    {
        return found(plain_ ? text_.find('\n', from) : text_.find_first_of("\r\n", from));
    }

    /// Where the record ends: at the end of a line, but not in quotation marks.
    std::size_t endOfRecord(std::size_t from)
    {
        const std::size_t begin = from + scanned_;
        const std::size_t end = plain_ ? endOfLine(begin) : found(endOfFields(begin));
        if (end != unknown) {
            lines_ += quotedLines_;
            quotedLines_ = scanned_ = 0;
            state_ = State::Begin;
            return end;
        }
        if (plain_ && begin < text_.size())
            state_ = isSeparator(text_.back()) ? State::Begin : State::Text;
        scanned_ = text_.size() - from;
        return unknown;
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
    enum class State {
        Begin, ///< a quotation mark here begins a field, or doubles the last mark
        Quoted,
        Text
    };

    bool isSeparator(char c) const { return separators_.find(c) != std::string::npos; }

    std::size_t found(std::size_t end) const
    {
        return end != std::string_view::npos ? end : ended_ ? text_.size() : unknown;
    }

    std::size_t endOfFields(std::size_t i)
    {
        while (i < text_.size()) {
            if (state_ == State::Quoted) {
                i = afterQuotes(i);
            } else if (state_ == State::Begin) {
                state_ = text_[i] == '"' ? State::Quoted : State::Text;
                i += state_ == State::Quoted;
            } else {
                i = std::min(text_.find_first_of(ends_, i), text_.size());
                if (i == text_.size() || !isSeparator(text_[i]))
                    break;
                state_ = State::Begin;
                ++i;
            }
        }
        return i < text_.size() ? i : std::string_view::npos;
    }

    std::size_t afterQuotes(std::size_t from)
    {
        const std::size_t mark = std::min(text_.find('"', from), text_.size());
        quotedLines_ += std::size_t(std::ranges::count(text_.substr(from, mark - from), '\n'));
        if (mark == text_.size())
            return mark;
        state_ = State::Begin;
        return mark + 1;
    }

    std::string separators_ = ",", ends_ = ",\r\n";
    std::string_view text_;
    bool ended_ = false, plain_ = true;
    std::size_t lines_ = 0;
    // Of the record whose end is not known yet:
    std::size_t scanned_ = 0, quotedLines_ = 0;
    State state_ = State::Begin;
};

} // namespace app::csv

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/record_blocks.h"

#include "app/base/csv_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace app::csv {
namespace {

constexpr std::size_t blockSize = 1 << 17;
constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";
constexpr std::size_t all = ~std::size_t(0);

// Finds the ends of records and lines in a text that may end in the middle of a record.
class Scan {
public:
    Scan(std::string_view text, bool ended)
        : text_(text), ended_(ended), plain_(text.find('"') == std::string_view::npos
                                             && text.find('\r') == std::string_view::npos)
    {
    }

    std::size_t lines() const { return lines_; }
    char at(std::size_t i) const { return text_[i]; }
    bool isEnd(std::size_t i) const { return i == text_.size(); }

    /// Where the line ends; `all` if that is not known yet.
    std::size_t endOfLine(std::size_t from) const
    {
        const std::size_t end = plain_ ? text_.find('\n', from) : text_.find_first_of("\r\n", from);
        return end != std::string_view::npos ? end : ended_ ? text_.size() : all;
    }

    /// Where the record ends: at the end of a line, but not in quotation marks.
    std::size_t endOfRecord(std::size_t from)
    {
        if (plain_)
            return endOfLine(from);
        for (std::size_t i = from;;) {
            if (i < text_.size() && text_[i] == '"')
                i = afterQuotes(i + 1);
            i = i == all ? all : text_.find_first_of(",\r\n", i);
            if (i >= text_.size())
                return ended_ ? text_.size() : all;
            if (text_[i++] != ',')
                return i - 1;
        }
    }

    /// Skips LF, CR LF or a lone CR, if there is one; `all` if that is not known yet.
    std::size_t afterBreak(std::size_t end)
    {
        if (end < text_.size() && text_[end] == '\r') {
            if (++end == text_.size() && !ended_)
                return all;
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
                return all;
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

} // namespace

bool RecordBlocks::first(RecordBlock& block) { return next(block, 1); }
bool RecordBlocks::next(RecordBlock& block) { return next(block, all); }

bool RecordBlocks::next(RecordBlock& block, std::size_t most)
{
    for (bool more = true; more; more = fill()) {
        block.line = line_;
        block.record = record_;
        const std::size_t taken = scan(block, most);
        block.bytes.assign(waiting_, 0, taken);
        waiting_.erase(0, taken);
        if (!block.places.empty())
            return true;
        refuseTooLong();
    }
    return false;
}

bool RecordBlocks::fill()
{
    if (ended_)
        return false;
    const std::size_t before = waiting_.size();
    waiting_.resize(before + blockSize);
    const std::size_t count = source_(waiting_.data() + before, blockSize);
    waiting_.resize(before + count);
    ended_ = count == 0;
    if (started_)
        return true;
    if (!ended_ && waiting_.size() < byteOrderMark.size())
        return fill();
    if (waiting_.starts_with(byteOrderMark))
        waiting_.erase(0, byteOrderMark.size());
    return started_ = true;
}

void RecordBlocks::refuseTooLong() const
{
    if (waiting_.size() > longestRecord)
        throw Refused{line_, waiting_.find('"') == std::string::npos
                                 ? QCoreApplication::translate("csv", "is too long for CSV.")
                                 : QCoreApplication::translate(
                                     "csv", "opens a quotation mark that is never closed.")};
}

std::size_t RecordBlocks::scan(RecordBlock& block, std::size_t most)
{
    block.places.clear();
    Scan scan(waiting_, ended_);
    std::size_t taken = 0, lines = 0;
    while (block.places.size() < most && !scan.isEnd(taken)) {
        const char c = scan.at(taken);
        const bool isBlank = c == '\n' || c == '\r' || (c == '#' && comments_);
        const std::size_t end = isBlank ? scan.endOfLine(taken) : scan.endOfRecord(taken);
        const std::size_t after = end == all ? all : scan.afterBreak(end);
        if (after == all)
            break;
        if (!isBlank)
            block.places.push_back(
                {std::uint32_t(taken), std::uint32_t(end), std::uint32_t(lines)});
        taken = after;
        lines = scan.lines();
    }
    line_ += lines;
    record_ += block.places.size();
    return taken;
}

} // namespace app::csv

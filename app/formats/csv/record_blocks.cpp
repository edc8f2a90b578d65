// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/record_blocks.h"

#include "app/base/csv_text.h"
#include "app/base/text.h"

#include <cstring>

namespace app::csv {
namespace {

constexpr std::size_t blockSize = 1 << 17;
constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

} // namespace

RecordBlocks::RecordBlocks(ByteSource source)
    : source_(std::move(source)),
      waiting_(std::make_unique_for_overwrite<char[]>(longestRecord + blockSize))
{
}

bool RecordBlocks::first(RecordBlock& block)
{
    scan_.setSeparators(",;\t"); // text in quotation marks after any of them may hold line breaks
    const bool found = next(block, 1);
    setSeparator(',');
    return found;
}

void RecordBlocks::setSeparator(char separator)
{
    scan_.setSeparators(separator == anyBlanks ? std::string(" \t") : std::string(1, separator));
}

bool RecordBlocks::next(RecordBlock& block) { return next(block, ~std::size_t(0)); }

bool RecordBlocks::next(RecordBlock& block, std::size_t most)
{
    for (bool more = true; more; more = fill()) {
        block.line = line_;
        block.record = record_;
        const std::size_t taken = scan(block, most);
        block.bytes.assign(waiting(), 0, taken);
        drop(taken);
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
    const std::size_t count = source_(waiting_.get() + size_, blockSize);
    size_ += count;
    ended_ = count == 0;
    if (started_)
        return true;
    if (!ended_ && size_ < byteOrderMark.size())
        return fill();
    if (waiting().starts_with(byteOrderMark))
        drop(byteOrderMark.size());
    return started_ = true;
}

void RecordBlocks::drop(std::size_t count)
{
    size_ -= count;
    std::memmove(waiting_.get(), waiting_.get() + count, size_);
}

void RecordBlocks::refuseTooLong() const
{
    if (size_ > longestRecord)
        throw Refused{line_, scan_.isQuoted()
                                 ? Text::tr("opens a quotation mark that is never closed.")
                                 : Text::tr("is too long for CSV.")};
}

std::size_t RecordBlocks::scan(RecordBlock& block, std::size_t most)
{
    block.places.clear();
    scan_.continueIn(waiting(), ended_);
    std::size_t taken = 0, lines = 0;
    while (block.places.size() < most && !scan_.isEnd(taken)) {
        if (inComment_ || (comments_ && scan_.at(taken) == '#')) {
            taken = passComment(taken);
            continue;
        }
        const std::size_t end = scan_.endOfRecord(taken);
        const std::size_t after = end == RecordScan::unknown ? end : scan_.afterBreak(end);
        if (after == RecordScan::unknown)
            break;
        if (end > taken) // otherwise the line is blank
            block.places.push_back(
                {std::uint32_t(taken), std::uint32_t(end), std::uint32_t(lines)});
        taken = after;
        lines = scan_.lines();
    }
    line_ += lines;
    record_ += block.places.size();
    return taken;
}

// The bytes of a comment need not wait for its end. Its line break is left, as a blank line.
std::size_t RecordBlocks::passComment(std::size_t from)
{
    const std::size_t end = scan_.endOfLine(from);
    inComment_ = end == RecordScan::unknown;
    return inComment_ ? waiting().size() : end;
}

} // namespace app::csv

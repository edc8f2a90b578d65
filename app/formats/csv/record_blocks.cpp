// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/record_blocks.h"

#include "app/base/csv_text.h"
#include "app/formats/csv/record_scan.h"

#include <QCoreApplication>

namespace app::csv {
namespace {

constexpr std::size_t blockSize = 1 << 17;
constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

} // namespace

bool RecordBlocks::first(RecordBlock& block) { return next(block, 1); }
bool RecordBlocks::next(RecordBlock& block) { return next(block, ~std::size_t(0)); }

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
    RecordScan scan(waiting_, ended_);
    std::size_t taken = 0, lines = 0;
    while (block.places.size() < most && !scan.isEnd(taken)) {
        const char c = scan.at(taken);
        const bool isBlank = c == '\n' || c == '\r' || (c == '#' && comments_);
        const std::size_t end = isBlank ? scan.endOfLine(taken) : scan.endOfRecord(taken);
        const std::size_t after = end == RecordScan::unknown ? end : scan.afterBreak(end);
        if (after == RecordScan::unknown)
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

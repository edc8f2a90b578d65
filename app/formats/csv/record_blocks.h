// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/csv/record_scan.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace app::csv {

/// Reads up to `size` bytes as soon as there are some; 0 at the end.
using ByteSource = std::function<std::size_t(char* bytes, std::size_t size)>;

/// Some whole records of a file, in order.
struct RecordBlock {
    struct Place {
        std::uint32_t begin, end; ///< in `bytes`, without the line break
        std::uint32_t line;       ///< counted from the block's first line
    };
    std::string bytes;
    std::vector<Place> places;
    std::size_t line = 1;   ///< of the block's first byte, counted from 1
    std::size_t record = 0; ///< the number of records before the block

    std::string_view text(const Place& place) const
    {
        return std::string_view(bytes).substr(place.begin, place.end - place.begin);
    }
};

/// Divides a file into blocks of whole records, which end where csv::Records (app/base/csv_text.h)
/// ends them. Memory is bounded; a block is complete as soon as the source has given some records.
class RecordBlocks {
public:
    explicit RecordBlocks(ByteSource source);

    /// The next block; false at the end. Reuses the memory of `block`. Throws Refused if a record
    /// is too long to be one.
    bool next(RecordBlock& block);
    /// The same for the first record alone, which may be a header, and whose separator is not
    /// known.
    bool first(RecordBlock& block);
    /// The separator of the further records; initially a comma.
    void setSeparator(char separator);

    /// Takes later lines that begin with # as records.
    void endComments() { comments_ = false; }
    /// Counts records from the next one on: the header is none.
    void countFromHere() { record_ = 0; }

private:
    bool next(RecordBlock& block, std::size_t most);
    bool fill();
    std::string_view waiting() const { return {waiting_.get(), size_}; }
    void drop(std::size_t count);
    void refuseTooLong() const;
    std::size_t scan(RecordBlock& block, std::size_t most);
    std::size_t passComment(std::size_t from);

    ByteSource source_;
    std::unique_ptr<char[]> waiting_; ///< the longest record, and what is read with its end
    std::size_t size_ = 0;            ///< of the bytes in `waiting_`, which are not in a block yet
    RecordScan scan_;
    std::size_t line_ = 1, record_ = 0;
    bool started_ = false, ended_ = false, comments_ = true, inComment_ = false;
};

} // namespace app::csv

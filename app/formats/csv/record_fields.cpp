// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/record_fields.h"

#include "app/base/csv_text.h"

#include <QBuffer>

#include <algorithm>

namespace app::csv {
namespace {

std::vector<std::string> unquotedFields(std::string_view record, std::size_t line, char separator)
{
    QByteArray bytes = QByteArray::fromRawData(record.data(), qsizetype(record.size()));
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::ReadOnly);
    Records text(buffer, separator);
    text.endComments();
    text.beginWithinFile();
    Record read;
    try {
        text.next(read);
    } catch (Refused& refused) {
        refused.line += line - 1; // the text counts from the record's first line
        throw;
    }
    return std::move(read.fields);
}

} // namespace

std::span<const std::string_view> RecordFields::of(std::string_view record, std::size_t line)
{
    fields_.clear();
    if (record.find('"') != std::string_view::npos || record.size() > longestRecord) {
        unquoted_ = unquotedFields(record, line, separator_);
        fields_.assign(unquoted_.begin(), unquoted_.end());
    } else if (separator_ == anyBlanks) {
        splitAtBlanks(record);
    } else {
        split(record);
    }
    return fields_;
}

void RecordFields::split(std::string_view record)
{
    for (std::size_t begin = 0;;) {
        const std::size_t end = std::min(record.find(separator_, begin), record.size());
        fields_.push_back(record.substr(begin, end - begin));
        if (end == record.size())
            return;
        begin = end + 1;
    }
}

void RecordFields::splitAtBlanks(std::string_view record)
{
    constexpr std::string_view blanks = " \t";
    for (std::size_t begin = record.find_first_not_of(blanks); begin < record.size();) {
        const std::size_t end = std::min(record.find_first_of(blanks, begin), record.size());
        fields_.push_back(record.substr(begin, end - begin));
        begin = record.find_first_not_of(blanks, end);
    }
    if (fields_.empty())
        fields_.emplace_back();
}

} // namespace app::csv

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/record_fields.h"

#include "app/base/csv_text.h"

#include <QBuffer>

#include <algorithm>

namespace app::csv {
namespace {

std::vector<std::string> unquoted(std::string_view record, std::size_t line)
{
    QByteArray bytes = QByteArray::fromRawData(record.data(), qsizetype(record.size()));
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::ReadOnly);
    Text text(buffer);
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
        unquoted_ = unquoted(record, line);
        fields_.assign(unquoted_.begin(), unquoted_.end());
        return fields_;
    }
    for (std::size_t begin = 0;;) {
        const std::size_t end = std::min(record.find(',', begin), record.size());
        fields_.push_back(record.substr(begin, end - begin));
        if (end == record.size())
            return fields_;
        begin = end + 1;
    }
}

} // namespace app::csv

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/csv_text.h"

#include "app/base/text.h"

#include <algorithm>
#include <utility>

namespace app::csv {
namespace {

constexpr qsizetype chunk = 1 << 16;
constexpr int end = -1;
constexpr QByteArrayView byteOrderMark("\xef\xbb\xbf");

bool endsLine(int c) { return c == end || c == '\n' || c == '\r'; }

} // namespace

int Records::peek()
{
    if (at_ == buffer_.size())
        fill();
    return at_ < buffer_.size() ? static_cast<unsigned char>(buffer_.at(at_)) : end;
}

void Records::fill()
{
    buffer_ = in_.read(chunk);
    at_ = 0;
    if (std::exchange(started_, true))
        return;
    // A pipe may give the mark byte by byte; some text must follow it in the buffer.
    for (QByteArray more = buffer_; !more.isEmpty() && buffer_.size() <= byteOrderMark.size();
         buffer_ += more)
        more = in_.read(chunk);
    if (buffer_.startsWith(byteOrderMark))
        at_ = byteOrderMark.size();
}

int Records::get()
{
    const int c = peek();
    at_ += c != end;
    line_ += c == '\n';
    return c;
}

void Records::skipLine()
{
    while (!endsLine(peek()))
        get();
    endRecord();
}

// Accepts CR LF, LF and a lone CR.
void Records::endRecord()
{
    if (peek() == '\r') {
        get();
        line_ += peek() != '\n';
    }
    if (peek() == '\n')
        get();
}

bool Records::endsField(int c) const { return endsLine(c) || separates(char(c), separator_); }

// Whether a field follows. Blanks at the end of a record separate nothing.
bool Records::takeSeparator()
{
    if (endsLine(peek()) || !endsField(peek()))
        return false;
    get();
    if (separator_ != anyBlanks)
        return true;
    while (!endsLine(peek()) && endsField(peek()))
        get();
    return !endsLine(peek());
}

bool Records::next(Record& record)
{
    while (endsLine(peek()) || (comments_ && peek() == '#')) {
        if (peek() == end)
            return false;
        skipLine();
    }
    record.line = line_;
    std::size_t count = 0, size = 0;
    if (separator_ == anyBlanks)
        takeSeparator(); // before the first field
    do {
        if (++size > longestRecord)
            throw Refused{line_, Text::tr("is too long for CSV.")};
        if (count == record.fields.size())
            record.fields.emplace_back();
        readField(record.fields[count++], size);
    } while (takeSeparator());
    record.fields.resize(count);
    endRecord();
    return true;
}

void Records::readField(std::string& field, std::size_t& size)
{
    field.clear();
    if (peek() == '"')
        readQuoted(field, size);
    else
        while (!endsField(peek())) {
            const char* const begin = buffer_.constData() + at_;
            const char* const stop = std::find_if(begin, buffer_.constEnd(),
                                                  [&](unsigned char c) { return endsField(c); });
            size += std::size_t(stop - begin);
            if (size > longestRecord)
                throw Refused{line_, Text::tr("is too long for CSV.")};
            field.append(begin, stop);
            at_ += stop - begin;
        }
}

void Records::readQuoted(std::string& field, std::size_t& size)
{
    const std::size_t begin = line_;
    get();
    for (;;) {
        const int c = get();
        if (c == end || ++size > longestRecord)
            throw Refused{begin, Text::tr("opens a quotation mark that is never closed.")};
        if (c == '"') {
            if (peek() != '"')
                break;
            get();
        }
        field += char(c);
    }
    if (!endsField(peek()))
        throw Refused{line_, Text::tr("has text after a closing quotation mark.")};
}

void appendField(std::string& text, std::string_view field)
{
    const bool plain = field.find_first_of(",\"\r\n") == std::string_view::npos
                       && !field.starts_with(' ') && !field.ends_with(' ')
                       && !field.starts_with('#');
    if (plain) {
        text += field;
        return;
    }
    text += '"';
    for (const char c : field) {
        text += c;
        if (c == '"')
            text += c;
    }
    text += '"';
}

} // namespace app::csv

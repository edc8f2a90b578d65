// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/write_tags.h"

#include "app/base/number.h"
#include "app/base/write_all.h"

#include <array>
#include <charconv>

namespace app::dxf::writing {
namespace {

constexpr std::size_t tagBufferSize = 1 << 16;

void appendWhole(std::string& text, std::uint64_t value, int base)
{
    std::array<char, 24> digits{};
    char* const end = std::to_chars(digits.begin(), digits.end(), value, base).ptr;
    for (char* digit = digits.begin(); digit != end; ++digit)
        text += *digit >= 'a' ? char(*digit - 'a' + 'A') : *digit;
}

} // namespace

void TagWriter::text(int code, std::string_view value)
{
    begin(code);
    text_ += value;
    end();
}

void TagWriter::whole(int code, std::int64_t value)
{
    begin(code);
    if (value < 0)
        text_ += '-';
    appendWhole(text_, std::uint64_t(value < 0 ? -value : value), 10);
    end();
}

void TagWriter::number(int code, double value)
{
    begin(code);
    appendNumber(text_, value);
    end();
}

void TagWriter::handle(int code, std::uint64_t value)
{
    begin(code);
    appendWhole(text_, value, 16);
    end();
}

void TagWriter::point(int code, const Point& point)
{
    flatPoint(code, point);
    number(code + 20, 0);
}

void TagWriter::flatPoint(int code, const Point& point)
{
    number(code, point.x);
    number(code + 10, point.y);
}

void TagWriter::all(std::initializer_list<Tag> tags)
{
    for (const auto& [code, value] : tags)
        text(code, value);
}

std::optional<QString> TagWriter::finish()
{
    flush();
    return failed_ ? std::optional(out_.errorString() + u'.') : std::nullopt;
}

void TagWriter::begin(int code)
{
    appendWhole(text_, std::uint64_t(code), 10);
    text_ += '\n';
}

void TagWriter::end()
{
    text_ += '\n';
    if (text_.size() > tagBufferSize)
        flush();
}

void TagWriter::flush()
{
    failed_ = failed_ || !writeAll(out_, text_);
    text_.clear();
}

} // namespace app::dxf::writing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/binary.h"

#include "app/base/number.h"

#include <QtEndian>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace app::dxf {
namespace {

constexpr std::string_view sentinel("AutoCAD Binary DXF\r\n\x1a\0", 22);

/// Reads values of a binary file, and appends them as text. A value that is not there ends it.
class BinaryValues {
public:
    explicit BinaryValues(std::string_view bytes) : rest_(bytes) {}

    template <class Number>
    std::optional<Number> take()
    {
        if (rest_.size() < sizeof(Number))
            return std::nullopt;
        const auto number = qFromLittleEndian<Number>(rest_.data());
        rest_.remove_prefix(sizeof(Number));
        return number;
    }
    template <class Number>
    bool addInteger(std::string& text)
    {
        const auto number = take<Number>();
        if (number)
            text += std::to_string(*number);
        return number.has_value();
    }
    bool addReal(std::string& text)
    {
        const auto number = take<double>();
        if (!number)
            return false;
        if (std::isfinite(*number))
            appendNumber(text, *number);
        else
            text += "nan";
        return true;
    }
    bool addString(std::string& text)
    {
        const std::size_t end = rest_.find('\0');
        if (end == std::string_view::npos)
            return false;
        for (const char c : rest_.substr(0, end))
            text += c == '\n' || c == '\r' ? ' ' : c;
        rest_.remove_prefix(end + 1);
        return true;
    }
    bool skipChunk(std::string&)
    {
        const auto size = take<std::uint8_t>();
        if (!size || rest_.size() < *size)
            return false;
        rest_.remove_prefix(*size);
        return true;
    }
    /// In R12 a code is a byte, larger ones are two more; later two bytes.
    std::optional<int> takeCode(bool isShort)
    {
        constexpr std::uint8_t larger = 255;
        if (!isShort)
            return take<std::int16_t>();
        const auto code = take<std::uint8_t>();
        if (code && *code == larger)
            return take<std::int16_t>();
        return code;
    }

private:
    std::string_view rest_;
};

using Add = bool (BinaryValues::*)(std::string& text);
constexpr Add real = &BinaryValues::addReal, string = &BinaryValues::addString;
constexpr Add flag = &BinaryValues::addInteger<std::uint8_t>;
constexpr Add int16 = &BinaryValues::addInteger<std::int16_t>;
constexpr Add int32 = &BinaryValues::addInteger<std::int32_t>;
constexpr Add int64 = &BinaryValues::addInteger<std::int64_t>;
constexpr Add chunk = &BinaryValues::skipChunk;

/// The type of the values of codes up to `last`, from the row before on.
struct CodeRange {
    int last;
    Add add;
};
constexpr std::array codeRanges{
    CodeRange{9, string},    CodeRange{59, real},     CodeRange{79, int16},
    CodeRange{99, int32},    CodeRange{109, string},  CodeRange{149, real},
    CodeRange{169, int64},   CodeRange{209, int16},   CodeRange{269, real},
    CodeRange{289, int16},   CodeRange{299, flag},    CodeRange{309, string},
    CodeRange{319, chunk},   CodeRange{369, string},  CodeRange{389, int16},
    CodeRange{399, string},  CodeRange{409, int16},   CodeRange{419, string},
    CodeRange{429, int32},   CodeRange{439, string},  CodeRange{459, int32},
    CodeRange{469, real},    CodeRange{1003, string}, CodeRange{1004, chunk},
    CodeRange{1009, string}, CodeRange{1059, real},   CodeRange{1070, int16},
    CodeRange{1071, int32},
};

} // namespace

bool isBinary(const QByteArray& begin)
{
    return begin.startsWith(QByteArrayView(sentinel.data(), qsizetype(sentinel.size())));
}

QByteArray textOfBinary(const QByteArray& bytes)
{
    const std::string_view content =
        std::string_view(bytes.constData(), std::size_t(bytes.size())).substr(sentinel.size());
    const bool isShort = content.size() > 1 && content[1] != '\0'; // 0 and "SECTION"
    BinaryValues values(content);
    std::string text;
    while (const auto code = values.takeCode(isShort)) {
        const auto range = std::ranges::lower_bound(codeRanges, *code, {}, &CodeRange::last);
        if (*code < -10 || range == codeRanges.end())
            break;
        const std::size_t before = text.size();
        text += std::to_string(*code) + '\n';
        if (!(values.*range->add)(text)) {
            text.resize(before);
            break;
        }
        text += '\n';
    }
    return QByteArray::fromStdString(text);
}

} // namespace app::dxf

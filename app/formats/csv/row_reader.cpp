// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/row_reader.h"

#include "app/base/csv_text.h"
#include "app/base/number.h"

#include <QCoreApplication>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace app::csv {
namespace {

constexpr double largest = 1e300; // keeps sums and differences finite

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blank = " \t";
    const auto first = std::min(text.find_first_not_of(blank), text.size());
    return text.substr(first, text.find_last_not_of(blank) + 1 - first);
}

QString shown(std::string_view field)
{
    constexpr qsizetype most = 40;
    const QString text = QString::fromUtf8(field.data(), qsizetype(field.size())).simplified();
    return u'“' + (text.size() > most ? text.left(most) + u'…' : text) + u'”';
}

std::optional<double> coordinate(std::string_view field)
{
    const auto number = parseNumber(trimmed(field));
    return number && std::abs(*number) <= largest ? number : std::nullopt;
}

/// Whether a field is a well-formed number, but beyond the range of calculations.
bool tooLarge(std::string_view field)
{
    long double value = 0; // its range exceeds that of double
    const char* const last = field.data() + field.size();
    const auto [end, error] = std::from_chars(field.data(), last, value);
    return error == std::errc{} && end == last && std::isfinite(value) && std::abs(value) > largest;
}

// Parses #rrggbb or #rrggbbaa.
std::optional<Colour> colour(std::string_view text)
{
    if ((text.size() != 7 && text.size() != 9) || text[0] != '#')
        return std::nullopt;
    std::uint32_t value = 0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data() + 1, last, value, 16);
    if (end != last || error != std::errc{})
        return std::nullopt;
    if (text.size() == 7)
        value = value << 8 | 255;
    return Colour{std::uint8_t(value >> 24), std::uint8_t(value >> 16), std::uint8_t(value >> 8),
                  std::uint8_t(value)};
}

QString columnsText(std::size_t count)
{
    return count == 1 ? Words::tr("1 column") : Words::tr("%1 columns").arg(count);
}

} // namespace

bool RowReader::readHeader(Fields fields, std::size_t line)
{
    if (coordinate(fields.front()) || tooLarge(trimmed(fields.front()))) {
        std::iota(positions_.begin(), positions_.end(), 0);
        return false;
    }
    positions_.fill(none);
    for (std::size_t i = 0; i < fields.size(); ++i)
        readName(fields[i], i, line);
    for (std::size_t i = 0; i < coordinateColumns; ++i)
        if (positions_[i] == none)
            throw Refused{line, Words::tr("is neither four numbers nor a header with x1, y1, "
                                          "x2 and y2.")};
    mostFields_ = fields.size();
    return true;
}

void RowReader::readName(std::string_view field, std::size_t index, std::size_t line)
{
    std::string name(trimmed(field));
    std::ranges::transform(name, name.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    const auto found = std::ranges::find(columnNames, name);
    if (found == columnNames.end()) {
        report_.push_back({Words::tr("column %1").arg(shown(name))});
        return;
    }
    auto& position = positions_[std::size_t(found - columnNames.begin())];
    if (position != none)
        throw Refused{line, Words::tr("names the column %1 twice.").arg(shown(name))};
    position = index;
}

Row RowReader::row(Fields fields, std::size_t line) const
{
    if (fields.size() > mostFields_)
        throw Refused{line, Words::tr("has %1; at most %2 are possible.")
                                .arg(columnsText(fields.size()))
                                .arg(mostFields_)};
    const Point a{number(fields, X1, line), number(fields, Y1, line)};
    const Point b{number(fields, X2, line), number(fields, Y2, line)};
    const std::size_t layer = positions_[LayerName];
    return {{a, a == b ? a : b},
            layer < fields.size() ? fields[layer] : std::string_view(),
            field(fields, StrokeColour),
            field(fields, Width)};
}

std::string_view RowReader::field(Fields fields, Column column) const
{
    const std::size_t at = positions_[column];
    return at < fields.size() ? trimmed(fields[at]) : std::string_view();
}

double RowReader::number(Fields fields, Column column, std::size_t line) const
{
    if (positions_[column] >= fields.size())
        throw Refused{
            line,
            Words::tr("has %1; x1, y1, x2 and y2 are needed.").arg(columnsText(fields.size()))};
    const auto text = field(fields, column);
    if (const auto value = coordinate(text))
        return *value;
    if (tooLarge(text))
        throw Refused{
            line,
            Words::tr("has %1, which is too large; numbers go up to 1e300.").arg(shown(text))};
    throw Refused{line, Words::tr("has %1 where a number is needed.").arg(shown(text))};
}

Style styleOf(const Row& row, std::size_t line)
{
    Style style{.stroke = Colour{}};
    if (!row.colour.empty()) {
        style.stroke = colour(row.colour);
        if (!style.stroke)
            throw Refused{line, Words::tr("has the colour %1; write it as #rrggbb or #rrggbbaa.")
                                    .arg(shown(row.colour))};
    }
    if (!row.width.empty()) {
        const auto number = coordinate(row.width);
        if (!number || *number < 0)
            throw Refused{line, Words::tr("has the width %1; write a number that is not negative.")
                                    .arg(shown(row.width))};
        style.width = *number;
    }
    return style;
}

} // namespace app::csv

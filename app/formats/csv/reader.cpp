// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/reader.h"

#include "app/base/csv_text.h"
#include "app/base/number.h"
#include "app/formats/csv/columns.h"
#include "app/formats/csv/lines_by_layer.h"

#include <QCoreApplication>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace app::csv {
namespace {

constexpr double largest = 1e300; // keeps sums and differences finite

QString tr(const char* text) { return QCoreApplication::translate("csv", text); }

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
    return count == 1 ? tr("1 column") : tr("%1 columns").arg(count);
}

class Reader {
public:
    explicit Reader(QIODevice& in) : text_(in) {}

    Imported read()
    {
        Record record;
        if (text_.next(record) && !readHeader(record))
            addRow(record);
        while (text_.next(record))
            addRow(record);
        finish();
        return std::move(imported_);
    }

private:
    // Reads a header; false if the first field is a number, so that the row is data.
    bool readHeader(const Record& record)
    {
        if (coordinate(record.fields.front()) || tooLarge(trimmed(record.fields.front()))) {
            std::iota(positions_.begin(), positions_.end(), 0);
            return false;
        }
        positions_.fill(none);
        for (std::size_t i = 0; i < record.fields.size(); ++i)
            readName(record, i);
        for (std::size_t i = 0; i < coordinateColumns; ++i)
            if (positions_[i] == none)
                throw Refused{record.line, tr("is neither four numbers nor a header with x1, y1, "
                                              "x2 and y2.")};
        if (positions_[StrokeColour] == 0)
            text_.endComments();
        mostFields_ = record.fields.size();
        return true;
    }

    void readName(const Record& record, std::size_t index)
    {
        std::string name(trimmed(record.fields[index]));
        std::ranges::transform(name, name.begin(), [](char c) {
            return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
        });
        const auto found = std::ranges::find(columnNames, name);
        if (found == columnNames.end()) {
            imported_.report.push_back({tr("column %1").arg(shown(name))});
            return;
        }
        auto& position = positions_[std::size_t(found - columnNames.begin())];
        if (position != none)
            throw Refused{record.line, tr("names the column %1 twice.").arg(shown(name))};
        position = index;
    }

    void addRow(const Record& record)
    {
        if (record.fields.size() > mostFields_)
            throw Refused{record.line, tr("has %1; at most %2 are possible.")
                                           .arg(columnsText(record.fields.size()))
                                           .arg(mostFields_)};
        if (lines_.size() == mostRows)
            throw Refused{record.line,
                          tr("exceeds the limit of %1 lines. Split the file.").arg(mostRows)};
        const Point a{number(record, X1), number(record, Y1)};
        const Point b{number(record, X2), number(record, Y2)};
        const StyleIndex style = styleOf(record);
        const std::size_t layer = positions_[LayerName];
        lines_.turnTo(layer < record.fields.size() ? record.fields[layer] : std::string_view());
        lines_.add({a, a == b ? a : b}, style);
    }

    std::string_view field(const Record& record, Column column) const
    {
        const std::size_t at = positions_[column];
        return at < record.fields.size() ? trimmed(record.fields[at]) : std::string_view();
    }

    double number(const Record& record, Column column) const
    {
        if (positions_[column] >= record.fields.size())
            throw Refused{
                record.line,
                tr("has %1; x1, y1, x2 and y2 are needed.").arg(columnsText(record.fields.size()))};
        const auto text = field(record, column);
        if (const auto value = coordinate(text))
            return *value;
        if (tooLarge(text))
            throw Refused{
                record.line,
                tr("has %1, which is too large; numbers go up to 1e300.").arg(shown(text))};
        throw Refused{record.line, tr("has %1 where a number is needed.").arg(shown(text))};
    }

    // Most rows have the style of the previous row.
    StyleIndex styleOf(const Record& record)
    {
        const auto strokeColour = field(record, StrokeColour), width = field(record, Width);
        if (!style_ || strokeColour != colour_ || width != width_) {
            style_ = lines_.style(styleOf(record.line, strokeColour, width));
            colour_ = strokeColour;
            width_ = width;
        }
        return *style_;
    }

    static Style styleOf(std::size_t line, std::string_view strokeColour, std::string_view width)
    {
        Style style{.stroke = Colour{}};
        if (!strokeColour.empty()) {
            style.stroke = colour(strokeColour);
            if (!style.stroke)
                throw Refused{line, tr("has the colour %1; write it as #rrggbb or #rrggbbaa.")
                                        .arg(shown(strokeColour))};
        }
        if (!width.empty()) {
            const auto number = coordinate(width);
            if (!number || *number < 0)
                throw Refused{
                    line,
                    tr("has the width %1; write a number that is not negative.").arg(shown(width))};
            style.width = *number;
        }
        return style;
    }

    void finish()
    {
        imported_.paged = false;
        if (const int beyond = lines_.beyond(); beyond > 0)
            imported_.report.push_back(
                {tr("layer names of lines, beyond the first %1 layers").arg(Containers::mostLayers),
                 beyond});
        imported_.document = lines_.take();
        imported_.rows = lines_.order();
    }

    static constexpr std::size_t none = ~std::size_t(0);
    Text text_;
    std::array<std::size_t, columnNames.size()> positions_{}; ///< of each column in a record
    std::size_t mostFields_ = columnNames.size();
    LinesByLayer lines_;
    std::string colour_, width_; ///< of the last row
    std::optional<StyleIndex> style_;
    Imported imported_;
};

} // namespace

Result<Imported> read(QIODevice& in)
{
    try {
        return Result<Imported>::of(Reader(in).read());
    } catch (const Refused& refused) {
        return Result<Imported>::failure(tr("line %1 %2").arg(refused.line).arg(refused.why));
    }
}

} // namespace app::csv

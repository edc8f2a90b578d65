// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/row_reader.h"

#include "app/base/csv_text.h"
#include "app/base/text.h"
#include "app/formats/csv/record_fields.h"
#include "app/formats/svg/colour.h"

#include <numeric>

namespace app::csv {
namespace {

QString shownField(std::string_view field)
{
    constexpr qsizetype most = 40;
    const QString text = QString::fromUtf8(field).simplified();
    return u'“' + (text.size() > most ? text.left(most) + u'…' : text) + u'”';
}

QString columnsText(std::size_t count)
{
    return count == 1 ? Text::tr("1 column") : Text::tr("%1 columns").arg(count);
}

// "“from”, “to”", the first ones.
QString namesText(Fields fields)
{
    constexpr qsizetype most = 6;
    QStringList names;
    for (const auto field : fields) {
        names << (names.size() < most ? shownField(trimmed(field)) : QStringLiteral("…"));
        if (names.size() > most)
            break;
    }
    return names.join(QStringLiteral(", "));
}

QString separatorText(char separator)
{
    return separator == ';'    ? Text::tr("semicolons")
           : separator == '\t' ? Text::tr("tabs")
                               : Text::tr("blanks");
}

// UTF-16 has a zero byte in almost every character of a table.
void refuseUtf16(std::string_view record, std::size_t line)
{
    if (record.find('\0') != record.npos)
        throw Refused{line, Text::tr("is not UTF-8. Save the table as CSV in UTF-8.")};
}

[[noreturn]] void refuseTooLarge(std::string_view number, std::size_t line)
{
    throw Refused{
        line,
        Text::tr("has %1, which is too large; numbers go up to 1e300.").arg(shownField(number))};
}

bool isNumber(std::string_view field, const Dialect& dialect)
{
    return coordinateOf(field, dialect) || isTooLarge(field);
}

} // namespace

bool RowReader::readHeader(std::string_view record, std::size_t line)
{
    refuseUtf16(record, line);
    dialect_ = dialectOf(record, line);
    RecordFields divided(dialect_.separator);
    const Fields fields = divided.of(record, line);
    if (dialect_.separator != ',')
        report_.push_back({Text::tr("table has %1 between its columns; a comma is a decimal comma")
                               .arg(separatorText(dialect_.separator)),
                           1, true});
    if (isNumber(fields.front(), dialect_)) {
        std::iota(positions_.begin(), positions_.end(), 0);
        return false;
    }
    positions_.fill(none);
    if (isWkt(fields.front())) { // then layer, colour and width
        std::iota(positions_.begin() + LayerName, positions_.end(), 1);
        geometry_ = 0;
        return false;
    }
    readNames(fields, line);
    for (std::size_t i = 0; i < coordinateColumns && !hasGeometries(); ++i)
        if (positions_[i] == none)
            throw Refused{line, Text::tr("is neither four numbers nor a header with x1, y1, x2 "
                                         "and y2; it has %1: %2.")
                                    .arg(columnsText(fields.size()), namesText(fields))};
    mostFields_ = fields.size();
    return true;
}

void RowReader::readNames(Fields fields, std::size_t line)
{
    const Header header(fields);
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto column = header.columnOf(fields[i]);
        if (!column && !namesCoordinates(fields) && !hasGeometries() && namesGeometry(fields[i])) {
            geometry_ = i;
            continue;
        }
        if (!column) {
            report_.push_back({Text::tr("column %1").arg(shownField(trimmed(fields[i])))});
            continue;
        }
        if (positions_[*column] != none)
            throw Refused{
                line, Text::tr("names the column %1 twice.").arg(shownField(trimmed(fields[i])))};
        positions_[*column] = i;
    }
}

Row RowReader::row(Fields fields, std::size_t line) const
{
    if (fields.size() > mostFields_)
        throw Refused{line, Text::tr("has %1; at most %2 are possible.")
                                .arg(columnsText(fields.size()))
                                .arg(mostFields_)};
    const std::size_t layer = positions_[LayerName];
    return {hasGeometries() ? clipping::Segment() : lineOf(fields, line),
            layer < fields.size() ? fields[layer] : std::string_view(), field(fields, StrokeColour),
            field(fields, Width)};
}

clipping::Segment RowReader::lineOf(Fields fields, std::size_t line) const
{
    const Point a{number(fields, X1, line), number(fields, Y1, line)};
    const Point b{number(fields, X2, line), number(fields, Y2, line)};
    if (dialect_.hasDecimalCommas())
        refuseMixture(fields, line);
    return {a, a == b ? a : b};
}

std::vector<Subpath> RowReader::geometry(Fields fields, std::size_t line) const
{
    if (geometry_ >= fields.size())
        throw Refused{line, Text::tr("has no geometry.")};
    return linesOfWkt(fields[geometry_], line);
}

std::string_view RowReader::field(Fields fields, Column column) const
{
    const std::size_t at = positions_[column];
    return at < fields.size() ? trimmed(fields[at]) : std::string_view();
}

// Where points and commas occur side by side, one of them separates thousands.
void RowReader::refuseMixture(Fields fields, std::size_t line) const
{
    std::string_view withComma, withPoint;
    for (const Column column : {X1, Y1, X2, Y2}) {
        const auto text = field(fields, column);
        withComma = text.find(',') != text.npos ? text : withComma;
        withPoint = text.find('.') != text.npos ? text : withPoint;
    }
    if (!withComma.empty() && !withPoint.empty())
        throw Refused{line, Text::tr("has both decimal commas and points: %1 and %2.")
                                .arg(shownField(withComma), shownField(withPoint))};
}

double RowReader::number(Fields fields, Column column, std::size_t line) const
{
    if (positions_[column] >= fields.size())
        throw Refused{
            line,
            Text::tr("has %1; x1, y1, x2 and y2 are needed.").arg(columnsText(fields.size()))};
    const auto text = field(fields, column);
    if (const auto value = coordinateOf(text, dialect_))
        return *value;
    if (isTooLarge(text))
        refuseTooLarge(text, line);
    throw Refused{line, Text::tr("has %1 where a number is needed.").arg(shownField(text))};
}

Style styleOf(const Row& row, const RowReader& rows, std::size_t line)
{
    Style style{.stroke = Colour{}};
    if (!row.colour.empty()) {
        style.stroke = svg::parseColour(row.colour);
        if (!style.stroke)
            throw Refused{line, Text::tr("has the colour %1; write it as #rrggbb or #rrggbbaa.")
                                    .arg(shownField(row.colour))};
    }
    if (!row.width.empty()) {
        if (isTooLarge(row.width))
            refuseTooLarge(row.width, line);
        const auto number = coordinateOf(row.width, rows.dialect());
        if (!number || *number < 0)
            throw Refused{line, Text::tr("has the width %1; write a number that is not negative.")
                                    .arg(shownField(row.width))};
        style.width = *number;
    }
    return style;
}

} // namespace app::csv

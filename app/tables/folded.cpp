// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tables/folded.h"

#include <algorithm>
#include <numeric>

namespace app {
namespace {

constexpr qsizetype gap = 2;          // between columns
constexpr qsizetype narrowText = 24;  // the minimal width of a text column
constexpr qsizetype mostLeading = 40; // of a line, for the columns that start every block
constexpr qsizetype unbroken = 1 << 20;
constexpr QStringView between = u",/"; // coordinates, and the folders of a path

struct Column {
    qsizetype index = 0;
    bool numeric = false;
    QStringList heading;
    qsizetype width = 0;
};

using Columns = std::vector<Column>;

qsizetype longest(const QStringList& lines)
{
    qsizetype most = 0;
    for (const QString& line : lines)
        most = std::max(most, line.size());
    return most;
}

qsizetype widthOf(const Columns& columns)
{
    return std::accumulate(columns.begin(), columns.end(), -gap,
                           [](qsizetype sum, const Column& c) { return sum + gap + c.width; });
}

/// The width of the heading or the longest cell, with cell lines of at most `most` characters.
qsizetype widthOf(const Table& table, const Column& column, qsizetype most)
{
    qsizetype width = longest(column.heading);
    for (const QStringList& row : table.rows)
        width = std::max(width, longest(brokenLines(oneLine(row[column.index]), most, between)));
    return width;
}

Columns foldedColumns(const Table& table)
{
    Columns columns;
    const auto numeric = numericColumns(table);
    for (qsizetype i = 0; i < table.names.size(); ++i) {
        Column column{i, numeric[std::size_t(i)], {oneLine(table.names[i])}, 0};
        column.width = widthOf(table, column, unbroken);
        columns.push_back(column);
    }
    return columns;
}

void breakHeadings(const Table& table, Columns& columns)
{
    for (Column& column : columns) {
        column.heading = oneLine(table.names[column.index]).split(u'_');
        column.width = widthOf(table, column, unbroken);
    }
}

/// Breaks texts; the last column no more than necessary.
void breakTexts(const Table& table, Columns& columns)
{
    for (Column& column : columns)
        if (const auto most = &column == &columns.front() ? mostLeading : narrowText;
            !column.numeric && column.width > most)
            column.width = widthOf(table, column, most);
    Column& last = columns.back();
    const qsizetype room = terminalWidth - (widthOf(columns) - last.width);
    if (!last.numeric && room > last.width)
        last.width = widthOf(table, last, room);
}

QString foldedLine(const Columns& columns, const std::vector<QStringList>& cells, qsizetype number)
{
    QString line;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const QString text = cells[i].value(number);
        line += columns[i].numeric ? text.rightJustified(columns[i].width)
                                   : text.leftJustified(columns[i].width);
        line += QString(gap, u' ');
    }
    while (line.endsWith(u' '))
        line.chop(1);
    return line + u'\n';
}

QString linesOf(const Columns& columns, const std::vector<QStringList>& cells)
{
    qsizetype most = 1;
    for (const QStringList& cell : cells)
        most = std::max(most, cell.size());
    QString text;
    for (qsizetype number = 0; number < most; ++number)
        text += foldedLine(columns, cells, number);
    return text;
}

QString blockOf(const Table& table, const Columns& columns)
{
    std::vector<QStringList> cells;
    for (const Column& column : columns)
        cells.push_back(column.heading);
    QString text = linesOf(columns, cells);
    for (const QStringList& row : table.rows) {
        for (std::size_t i = 0; i < columns.size(); ++i)
            cells[i] = brokenLines(oneLine(row[columns[i].index]), columns[i].width, between);
        text += linesOf(columns, cells);
    }
    return text;
}

/// The number of columns at the left that identify the rows: the text columns there, at least one.
std::size_t leadingOf(const Columns& columns)
{
    std::size_t count = 1;
    while (count < columns.size() && !columns[count].numeric
           && widthOf({columns.begin(), columns.begin() + std::ptrdiff_t(count) + 1})
                  <= mostLeading)
        ++count;
    return count;
}

QString blocksOf(const Table& table, const Columns& columns)
{
    const std::size_t leading = leadingOf(columns);
    const Columns head(columns.begin(), columns.begin() + std::ptrdiff_t(leading));
    QString text;
    for (std::size_t i = leading; i < columns.size();) {
        Columns block = head;
        do
            block.push_back(columns[i++]);
        while (i < columns.size() && widthOf(block) + gap + columns[i].width <= terminalWidth);
        text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + blockOf(table, block);
    }
    return text;
}

} // namespace

QStringList brokenLines(const QString& text, qsizetype width, QStringView after)
{
    QStringList lines;
    qsizetype begin = 0;
    while (text.size() - begin > width) {
        qsizetype end = begin, next = begin; // the line's end; the next line's beginning
        for (qsizetype i = begin; i < text.size() && (i <= begin + width || end == begin); ++i) {
            const bool space = text[i] == u' ';
            const bool fits = space || i < begin + width || end == begin;
            if (!fits || !(space || after.contains(text[i])))
                continue;
            end = space ? i : i + 1;
            next = i + 1;
        }
        if (next == begin || next >= text.size())
            break;
        lines << text.mid(begin, end - begin);
        begin = next;
    }
    lines << text.mid(begin);
    return lines;
}

QString folded(const Table& table)
{
    Columns columns = foldedColumns(table);
    if (columns.empty())
        return {};
    if (widthOf(columns) > terminalWidth)
        breakHeadings(table, columns);
    if (widthOf(columns) > terminalWidth)
        breakTexts(table, columns);
    return widthOf(columns) <= terminalWidth || columns.size() == 1 ? blockOf(table, columns)
                                                                    : blocksOf(table, columns);
}

} // namespace app

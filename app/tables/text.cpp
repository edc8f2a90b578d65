// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tables/table.h"

#include <algorithm>

namespace app {
namespace {

QString alignedLine(const QStringList& fields, const std::vector<qsizetype>& widths,
                    const std::vector<bool>& numeric)
{
    QString line;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const QString field = oneLine(fields[qsizetype(i)]);
        line += numeric[i] ? field.rightJustified(widths[i]) : field.leftJustified(widths[i]);
        line += QStringLiteral("  ");
    }
    while (line.endsWith(u' '))
        line.chop(1);
    return line + u'\n';
}

std::vector<qsizetype> widthsOf(const Table& table)
{
    std::vector<qsizetype> widths;
    for (qsizetype i = 0; i < table.names.size(); ++i) {
        qsizetype width = table.names[i].size();
        for (const QStringList& row : table.rows)
            width = std::max(width, row[i].size());
        widths.push_back(width);
    }
    return widths;
}

} // namespace

/// Columns for people, numbers to the right, and the notes below. What is true of all rows is said
/// once after the last of some tables of which the same is true.
QString plainText(std::span<const Table> tables)
{
    QString text;
    for (const Table& table : tables) {
        if (&table != &tables.front())
            text += u'\n';
        if (!table.title.isEmpty())
            text += oneLine(table.title) + QStringLiteral("\n\n");
        const auto widths = widthsOf(table);
        const auto numeric = numericColumns(table);
        text += alignedLine(table.names, widths, numeric);
        for (const QStringList& row : table.rows)
            text += alignedLine(row, widths, numeric);
        if (!table.notes.isEmpty())
            text += u'\n';
        for (const QString& note : table.notes)
            text += oneLine(note) + u'\n';
        const Table* next = &table == &tables.back() ? nullptr : &table + 1;
        if (table.facts.empty() || (next && next->facts == table.facts))
            continue;
        text += u'\n';
        for (const auto& [name, value] : table.facts)
            text += (name + QStringLiteral(": ")).leftJustified(12) + oneLine(value) + u'\n';
    }
    return text;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/table.h"

#include "app/command_line/refusal.h"
#include "app/formats/csv/text.h"

#include <algorithm>

namespace app {
namespace {

QString csvLine(const QStringList& fields)
{
    std::string line;
    for (const QString& field : fields) {
        if (&field != &fields.front())
            line += ',';
        csv::appendField(line, field.toStdString());
    }
    return QString::fromStdString(line) + u'\n';
}

bool isNumber(const QString& field)
{
    bool is = false;
    field.toDouble(&is);
    return is;
}

QString alignedLine(const QStringList& fields, const std::vector<qsizetype>& widths,
                    const std::vector<bool>& numeric)
{
    QString line;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const QString& field = fields[qsizetype(i)];
        line += numeric[i] ? field.rightJustified(widths[i]) : field.leftJustified(widths[i]);
        line += QStringLiteral("  ");
    }
    while (line.endsWith(u' '))
        line.chop(1);
    return line + u'\n';
}

QString alignedText(const Table& table)
{
    std::vector<qsizetype> widths;
    std::vector<bool> numeric;
    for (qsizetype i = 0; i < table.names.size(); ++i) {
        qsizetype width = table.names[i].size();
        for (const QStringList& row : table.rows)
            width = std::max(width, row[i].size());
        widths.push_back(width);
        numeric.push_back(std::ranges::all_of(
            table.rows, [&](const QStringList& row) { return isNumber(row[i]); }));
    }
    QString text = alignedLine(table.names, widths, numeric);
    for (const QStringList& row : table.rows)
        text += alignedLine(row, widths, numeric);
    return text;
}

} // namespace

Option tableOption()
{
    return {{"format"}, "text|csv", Commands::tr("How to print the table (text).")};
}

QString tableText(const Table& table, const Given& given)
{
    if (given.choice(QStringLiteral("format"), {"text", "csv"}) == 0)
        return alignedText(table);
    QString text = csvLine(table.names);
    for (const QStringList& row : table.rows)
        text += csvLine(row);
    return text;
}

} // namespace app

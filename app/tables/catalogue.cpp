// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/tables/table.h"

#include <algorithm>

namespace app {

// Each function is defined in the file of its format.
QString plainText(std::span<const Table> tables);
QString csvText(std::span<const Table> tables);
QString jsonText(std::span<const Table> tables);
QString markdownText(std::span<const Table> tables);
QString latexText(std::span<const Table> tables);

// THE CATALOGUE. To add a format, write its file in app/tables/, declare its function above, and
// add its row here.
std::vector<TableFormat> tableFormats()
{
    return {
        {"text", "txt", Text::tr("Text"), plainText},
        {"csv", "csv", Text::tr("CSV"), csvText},
        {"json", "json", Text::tr("JSON"), jsonText},
        {"markdown", "md", Text::tr("Markdown"), markdownText},
        {"latex", "tex", Text::tr("LaTeX"), latexText},
    };
}

QString oneLine(const QString& text)
{
    QString line = text;
    for (QChar& c : line)
        if (c.category() == QChar::Other_Control || c == QChar::LineSeparator
            || c == QChar::ParagraphSeparator)
            c = u' ';
    return line;
}

bool isNumber(const QString& field)
{
    bool is = false;
    field.toDouble(&is);
    return is;
}

std::vector<bool> numericColumns(const Table& table)
{
    std::vector<bool> numeric;
    for (qsizetype i = 0; i < table.names.size(); ++i)
        numeric.push_back(std::ranges::all_of(table.rows, [&](const QStringList& row) {
            return row[i].isEmpty() || isNumber(row[i]);
        }));
    return numeric;
}

} // namespace app

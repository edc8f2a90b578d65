// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/paper_runs.h"

#include "app/base/csv_text.h"
#include "app/base/number.h"

#include <QFile>

namespace app {
namespace {

// The file is compiled in and checked by tests, so errors need no handling.
std::vector<std::vector<std::string>> recordsOf(const QString& name)
{
    QFile file(QStringLiteral(":/paper/%1.csv").arg(name));
    file.open(QIODevice::ReadOnly);
    std::vector<std::vector<std::string>> records;
    csv::Records text(file);
    for (csv::Record record; text.next(record);)
        records.push_back(record.fields);
    return records;
}

double numberIn(const std::string& field) { return parseNumber(field).value(); }

PaperTable table(const QString& key, std::uint64_t lines)
{
    PaperTable result{key, lines, {}};
    const auto records = recordsOf(key), percentages = recordsOf(QStringLiteral("percentages"));
    for (std::size_t c = 1; c < records[0].size(); ++c) {
        PaperColumn column{QString::fromStdString(records[0][c]),
                           paperAlgorithm(QString::fromStdString(records[0][c])),
                           {},
                           numberIn(records.back()[c]),
                           {}};
        for (std::size_t r = 1; r + 1 < records.size(); ++r)
            column.runs.push_back(numberIn(records[r][c]));
        for (const auto& row : percentages)
            if (row[0] == key.toStdString() && c < row.size())
                column.printedPercentage = numberIn(row[c]);
        result.columns.push_back(std::move(column));
    }
    return result;
}

} // namespace

const clipping::Algorithm* paperAlgorithm(const QString& name)
{
    return clipping::findAlgorithm(name == u"Prop." ? "MD" : name.toStdString());
}

std::vector<PaperTable> paperTables()
{
    return {table(QStringLiteral("table1"), 1'000'000),
            table(QStringLiteral("table2"), 10'000'000)};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/csv_text.h"
#include "app/tables/table.h"

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

} // namespace

/// Each table starts with a line of its names. Facts become further columns with the same value in
/// each row. An empty line separates tables. Title and notes are for
/// people and left out.
QString csvText(std::span<const Table> tables)
{
    QString text;
    for (const Table& table : tables) {
        if (&table != &tables.front())
            text += u'\n';
        QStringList names, values;
        for (const auto& [name, value] : table.facts) {
            names << name;
            values << value;
        }
        text += csvLine(table.names + names);
        for (const QStringList& row : table.rows)
            text += csvLine(row + values);
    }
    return text;
}

} // namespace app

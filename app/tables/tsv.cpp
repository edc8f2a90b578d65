// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tables/table.h"

namespace app {

/// Fields between tabs, an empty line between tables; names and rows only.
QString tsvText(std::span<const Table> tables)
{
    QString text;
    const auto add = [&](const QStringList& fields) {
        QStringList cells;
        for (const QString& field : fields)
            cells << oneLine(field);
        text += cells.join(u'\t') + u'\n';
    };
    for (const Table& table : tables) {
        if (&table != &tables.front())
            text += u'\n';
        add(table.names);
        for (const QStringList& row : table.rows)
            add(row);
    }
    return text;
}

} // namespace app

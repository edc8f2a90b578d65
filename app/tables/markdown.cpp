// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tables/table.h"

namespace app {
namespace {

/// Escapes the characters that are markup in a cell or a line.
QString markdownEscaped(const QString& text)
{
    QString result;
    for (const QChar c : oneLine(text)) {
        if (QStringView(u"\\|*_`<>[]&~$").contains(c))
            result += u'\\';
        result += c;
    }
    return result;
}

QString rowLine(const QStringList& fields)
{
    QStringList cells;
    for (const QString& field : fields)
        cells << markdownEscaped(field);
    return QStringLiteral("| ") + cells.join(QStringLiteral(" | ")) + QStringLiteral(" |\n");
}

} // namespace

/// Pipe tables, each followed by a list of its facts and notes.
QString markdownText(std::span<const Table> tables)
{
    QString text;
    for (const Table& table : tables) {
        if (&table != &tables.front())
            text += u'\n';
        if (!table.title.isEmpty())
            text += QStringLiteral("## ") + markdownEscaped(table.title) + QStringLiteral("\n\n");
        text += rowLine(table.names) + u'|';
        for (const bool numeric : numericColumns(table))
            text += numeric ? QStringLiteral("---:|") : QStringLiteral(":---|");
        text += u'\n';
        for (const QStringList& row : table.rows)
            text += rowLine(row);
        if (!table.facts.empty() || !table.notes.isEmpty())
            text += u'\n';
        for (const auto& [name, value] : table.facts)
            text += QStringLiteral("- ") + markdownEscaped(name) + QStringLiteral(": ")
                    + markdownEscaped(value) + u'\n';
        for (const QString& note : table.notes)
            text += QStringLiteral("- ") + markdownEscaped(note) + u'\n';
    }
    return text;
}

} // namespace app

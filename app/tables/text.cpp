// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tables/folded.h"
#include "app/tables/table.h"

namespace app {
namespace {

QString paragraph(const QString& text, qsizetype indent = 0)
{
    const QStringList lines = brokenLines(oneLine(text), terminalWidth - indent);
    return lines.join(u'\n' + QString(indent, u' ')) + u'\n';
}

} // namespace

/// Columns for people, numbers right-aligned, followed by the notes. Facts that several consecutive
/// tables share are printed once, after the last of these tables.
QString plainText(std::span<const Table> tables)
{
    constexpr qsizetype factIndent = 12;
    QString text;
    for (const Table& table : tables) {
        if (&table != &tables.front())
            text += u'\n';
        if (!table.title.isEmpty())
            text += paragraph(table.title);
        if (!table.title.isEmpty() && !table.names.isEmpty())
            text += u'\n';
        text += folded(table);
        if (!table.notes.isEmpty())
            text += u'\n';
        for (const QString& note : table.notes)
            text += paragraph(note);
        const Table* next = &table == &tables.back() ? nullptr : &table + 1;
        if (table.facts.empty() || (next && next->facts == table.facts))
            continue;
        text += u'\n';
        for (const auto& [name, value] : table.facts)
            text += (name + QStringLiteral(": ")).leftJustified(factIndent)
                    + paragraph(value, factIndent);
    }
    return text;
}

} // namespace app

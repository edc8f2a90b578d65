// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tables/table.h"

namespace app {
namespace {

/// What means something to TeX, as itself; signs beyond ASCII that Clearcut writes, in TeX.
QString escaped(const QString& text)
{
    QString result;
    for (const QChar c : text)
        switch (c.unicode()) {
        case u'\\':
            result += QStringLiteral("\\textbackslash{}");
            break;
        case u'~':
            result += QStringLiteral("\\textasciitilde{}");
            break;
        case u'^':
            result += QStringLiteral("\\textasciicircum{}");
            break;
        case u'<':
            result += QStringLiteral("\\textless{}");
            break;
        case u'>':
            result += QStringLiteral("\\textgreater{}");
            break;
        case u'&':
        case u'%':
        case u'$':
        case u'#':
        case u'_':
        case u'{':
        case u'}':
            result += u'\\';
            [[fallthrough]];
        default:
            result += c;
        }
    return result;
}

QString rowOf(const QStringList& fields)
{
    QStringList cells;
    for (const QString& field : fields)
        cells << escaped(field);
    return cells.join(QStringLiteral(" & ")) + QStringLiteral(" \\\\\n");
}

QString noteOf(const Table& table)
{
    QStringList facts;
    for (const auto& [name, value] : table.facts)
        facts << escaped(name) + QStringLiteral(": ") + escaped(value);
    QStringList lines;
    if (!facts.isEmpty())
        lines << facts.join(QStringLiteral("; ")) + u'.';
    for (const QString& note : table.notes)
        lines << escaped(note);
    if (lines.isEmpty())
        return {};
    return QStringLiteral(
               "\\par\\smallskip\\begin{minipage}{\\linewidth}\\footnotesize\\raggedright\n")
           + lines.join(QStringLiteral("\\par\n")) + QStringLiteral("\n\\end{minipage}\n");
}

QString floatOf(const Table& table)
{
    QString columns;
    for (const bool numeric : numericColumns(table))
        columns += numeric ? u'r' : u'l';
    QString text = QStringLiteral("\\begin{table}[htbp]\n\\centering\n");
    if (!table.title.isEmpty())
        text += QStringLiteral("\\caption{%1}\n").arg(escaped(table.title));
    if (!table.key.isEmpty())
        text += QStringLiteral("\\label{tab:%1}\n").arg(table.key);
    text +=
        QStringLiteral("\\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}{!}{%\n"
                       "\\begin{tabular}{@{}%1@{}}\n\\toprule\n")
            .arg(columns)
        + rowOf(table.names) + QStringLiteral("\\midrule\n");
    for (const QStringList& row : table.rows)
        text += rowOf(row);
    return text + QStringLiteral("\\bottomrule\n\\end{tabular}}\n") + noteOf(table)
           + QStringLiteral("\\end{table}\n");
}

} // namespace

/// A whole document of floating tables with booktabs' rules, so that it compiles as it is; to have
/// them in another one, take what is between its begin and end. Wide tables shrink to the line.
QString latexText(std::span<const Table> tables)
{
    QString text = QStringLiteral("\\documentclass{article}\n\\usepackage[utf8]{inputenc}\n"
                                  "\\usepackage[T1]{fontenc}\n\\usepackage{booktabs}\n"
                                  "\\usepackage{graphicx}\n\\begin{document}\n");
    for (const Table& table : tables)
        text += floatOf(table);
    return text + QStringLiteral("\\end{document}\n");
}

} // namespace app

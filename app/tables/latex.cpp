// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tables/table.h"

#include <map>

namespace app {
namespace {

/// What means something to TeX, as itself. A row that begins with [ or * would be taken for what
/// may follow the end of the one before.
const std::map<char16_t, const char*>& signs()
{
    static const std::map<char16_t, const char*> all{
        {u'\\', "\\textbackslash{}"},
        {u'~', "\\textasciitilde{}"},
        {u'^', "\\textasciicircum{}"},
        {u'<', "\\textless{}"},
        {u'>', "\\textgreater{}"},
        {u'|', "\\textbar{}"},
        {u'"', "\\textquotedbl{}"},
        {u'[', "{[}"},
        {u'*', "{*}"},
        {u'&', "\\&"},
        {u'%', "\\%"},
        {u'$', "\\$"},
        {u'#', "\\#"},
        {u'_', "\\_"},
        {u'{', "\\{"},
        {u'}', "\\}"},
        {u'\u00a0', "~"},
        {u'\u202f', "~"},
        {u'\u2009', "~"},
        {u'\u2212', "$-$"},
        {u'\u00d7', "$\\times$"},
    };
    return all;
}

/// What every TeX knows, with the packages below: Latin letters, and quotation marks and dashes.
bool isKnown(QChar c) { return c < u'\u0180' || (c >= u'\u2013' && c <= u'\u2026'); }

QString escaped(const QString& text)
{
    QString result;
    for (const QChar c : oneLine(text))
        if (const auto sign = signs().find(c.unicode()); sign != signs().end())
            result += QLatin1StringView(sign->second);
        else
            result += isKnown(c)
                          ? QString(c)
                          : QStringLiteral("U+%1 ").arg(c.unicode(), 4, 16, QLatin1Char('0'));
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

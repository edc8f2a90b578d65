// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tables/table.h"

#include <algorithm>
#include <map>

namespace app {
namespace {

/// Replacements for the characters that are special in TeX. [ and * are included because at the
/// start of a row TeX would read them as arguments of the preceding \\.
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

/// Characters that every TeX typesets with the packages below: Latin letters, quotation marks and
/// dashes.
bool isKnown(QChar c) { return c < u'\u0180' || (c >= u'\u2013' && c <= u'\u2026'); }

QString latexEscaped(const QString& text)
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
        cells << latexEscaped(field);
    return cells.join(QStringLiteral(" & ")) + QStringLiteral(" \\\\\n");
}

QString noteOf(const Table& table)
{
    QStringList facts;
    for (const auto& [name, value] : table.facts)
        facts << latexEscaped(name) + QStringLiteral(": ") + latexEscaped(value);
    QStringList lines;
    if (!facts.isEmpty())
        lines << facts.join(QStringLiteral("; ")) + u'.';
    for (const QString& note : table.notes)
        lines << latexEscaped(note);
    if (lines.isEmpty())
        return {};
    return QStringLiteral(
               "\\par\\smallskip\\begin{minipage}{\\linewidth}\\footnotesize\\raggedright\n")
           + lines.join(QStringLiteral("\\par\n")) + QStringLiteral("\n\\end{minipage}\n");
}

QString columnTypes(const Table& table)
{
    QString columns;
    for (const bool numeric : numericColumns(table))
        columns += numeric ? u'r' : u'l';
    return columns;
}

QString rowsOf(const Table& table)
{
    QString text;
    for (const QStringList& row : table.rows)
        text += rowOf(row);
    return text;
}

QString captionOf(const Table& table)
{
    QString text;
    if (!table.title.isEmpty())
        text += QStringLiteral("\\caption{%1}").arg(latexEscaped(table.title));
    if (!table.key.isEmpty())
        text += QStringLiteral("\\label{tab:%1}").arg(table.key);
    return text;
}

/// A floating table, shrunk to the line width.
QString floatOf(const Table& table)
{
    const QString caption = captionOf(table);
    return QStringLiteral("\\begin{table}[htbp]\n\\centering\n")
           + (caption.isEmpty() ? caption : caption + u'\n')
           + QStringLiteral(
                 "\\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}{!}{%\n"
                 "\\begin{tabular}{@{}%1@{}}\n\\toprule\n")
                 .arg(columnTypes(table))
           + rowOf(table.names) + QStringLiteral("\\midrule\n") + rowsOf(table)
           + QStringLiteral("\\bottomrule\n\\end{tabular}}\n") + noteOf(table)
           + QStringLiteral("\\end{table}\n");
}

/// How to typeset a table that is longer than a page and therefore cannot be scaled.
struct Setting {
    const char* size;     ///< type size
    qsizetype letters;    ///< letters that fit into a line of an article, measured with digits and
                          ///< as many gaps
    const char* turned{}; ///< the environment that rotates the page, if any
};

const Setting& settingFor(const Table& table)
{
    static constexpr Setting all[]{{"\\normalsize", 66},
                                   {"\\footnotesize", 74},
                                   {"\\footnotesize", 116, "landscape"},
                                   {"\\scriptsize", 130, "landscape"},
                                   {"\\tiny", 145, "landscape"}}; // also for wider tables
    qsizetype letters = 0;
    for (qsizetype c = 0; c < table.names.size(); ++c) {
        qsizetype widest = table.names[c].size();
        for (const QStringList& row : table.rows)
            widest = std::max(widest, row[c].size());
        letters += widest + 1;
    }
    const auto found = std::ranges::find_if(
        all, [&](const Setting& setting) { return letters <= setting.letters; });
    return found == std::end(all) ? *std::rbegin(all) : *found;
}

/// A table that continues from page to page and repeats its headings on each.
QString longTableOf(const Table& table)
{
    const Setting& setting = settingFor(table);
    const QString head = QStringLiteral("\\toprule\n") + rowOf(table.names)
                         + QStringLiteral("\\midrule\n"),
                  caption = table.title.isEmpty() ? QString()
                                                  : captionOf(table) + QStringLiteral("\\\\\n");
    const QString text =
        QStringLiteral("{%1\\setlength{\\tabcolsep}{3pt}\n\\begin{longtable}{@{}%2@{}}\n")
            .arg(QLatin1StringView(setting.size), columnTypes(table))
        + caption + head + QStringLiteral("\\endfirsthead\n") + head
        + QStringLiteral("\\endhead\n\\midrule\n\\endfoot\n\\bottomrule\n\\endlastfoot\n")
        + rowsOf(table) + QStringLiteral("\\end{longtable}}\n") + noteOf(table);
    return setting.turned ? QStringLiteral("\\begin{%1}\n%2\\end{%1}\n")
                                .arg(QLatin1StringView(setting.turned), text)
                          : text;
}

/// The rows that fit on a page, with title and notes; a longer table would run off the page.
constexpr std::size_t mostOnAPage = 30;

QString textOf(const Table& table)
{
    return table.rows.size() > mostOnAPage ? longTableOf(table) : floatOf(table);
}

} // namespace

/// A complete document of tables with booktabs rules, which compiles as it is. To use the tables in
/// another document, copy what is between its \begin and \end. Tables of at most a page float, and
/// wide ones shrink to the line width. Longer tables continue from page to page (longtable), wide
/// ones in smaller type or rotated.
QString latexText(std::span<const Table> tables)
{
    QString text =
        QStringLiteral("\\documentclass{article}\n\\usepackage[utf8]{inputenc}\n"
                       "\\usepackage[T1]{fontenc}\n\\usepackage{booktabs}\n"
                       "\\usepackage{graphicx}\n\\usepackage{longtable}\n\\usepackage{lscape}\n"
                       "\\begin{document}\n");
    for (const Table& table : tables)
        text += textOf(table);
    return text + QStringLiteral("\\end{document}\n");
}

} // namespace app

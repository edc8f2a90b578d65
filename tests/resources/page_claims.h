// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRegularExpression>
#include <QString>
#include <QStringList>

#include <cmath>
#include <vector>

/// A measured number on a page, as resources/README.md defines it: `8.7 %<!-- outside / visible
/// @ published -->`, and after it in the same paragraph the command that prints it.
struct Claim {
    QString number;     ///< as it stands on the page: "8.7", "1,088"
    bool percent;       ///< given in per cent
    QString expression; ///< which of the numbers that the command prints
    QString command;    ///< without the program's name; empty if there is none
};

/// Paragraphs of markdown, each as one line: the text between empty lines. Rows of tables and
/// lines of code count as one paragraph too.
inline QStringList paragraphsOf(const QString& markdown)
{
    static const QRegularExpression gap(QStringLiteral("\n\\s*\n"));
    QStringList all = markdown.split(gap, Qt::SkipEmptyParts);
    for (QString& one : all)
        one = one.simplified();
    return all;
}

/// `clearcut …` as the page shows it, without `clearcut`.
inline QStringList commandsOf(const QString& paragraph)
{
    static const QRegularExpression code(QStringLiteral("`clearcut ([^`]+)`"));
    QStringList all;
    for (auto found = code.globalMatch(paragraph); found.hasNext();)
        all << found.next().captured(1);
    return all;
}

inline std::vector<Claim> claimsOf(const QString& paragraph)
{
    static const QRegularExpression marked(
        QStringLiteral("(\\d[\\d,]*(?:\\.\\d+)?)( %| ulps?)?<!-- (.+?) -->"));
    std::vector<Claim> all;
    for (auto found = marked.globalMatch(paragraph); found.hasNext();) {
        const auto match = found.next();
        all.push_back({match.captured(1), match.captured(2) == QStringLiteral(" %"),
                       match.captured(3), commandsOf(paragraph.mid(match.capturedEnd())).value(0)});
    }
    return all;
}

/// Whether `measured` rounds to the number on the page.
inline bool agrees(const QString& number, double measured)
{
    const QString plain = QString(number).remove(u',');
    const auto point = plain.indexOf(u'.');
    const auto decimals = point < 0 ? 0 : plain.size() - point - 1;
    constexpr double room = 1e-9; // for the rounding of this comparison
    return std::abs(plain.toDouble() - measured) <= 0.5 * std::pow(10, -double(decimals)) + room;
}

/// A row of the table "What it costs".
struct CostRow {
    QString line;      ///< "-50,-20,60,30", or what else stands in its place
    QStringList cells; ///< "8 / 0 / 0 / 0", one for each form
};

/// Rows of four cells, or three where there is no published form; without their heading.
inline std::vector<CostRow> costRowsOf(const QString& markdown)
{
    static const QRegularExpression row(
        QStringLiteral("^\\| [^|]+ \\| ([^|]+) \\|((?: \\d[^|]*/[^|]*/[^|]*/[^|]* \\|)+)$"),
        QRegularExpression::MultilineOption);
    std::vector<CostRow> all;
    for (auto found = row.globalMatch(markdown); found.hasNext();) {
        const auto match = found.next();
        CostRow next{QString(match.captured(1)).remove(u'`'), {}};
        for (const QString& cell : match.captured(2).split(u'|', Qt::SkipEmptyParts))
            next.cells << cell.trimmed();
        all.push_back(next);
    }
    return all;
}

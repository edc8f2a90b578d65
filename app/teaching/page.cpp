// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/page.h"

#include "app/base/latin.h"
#include "clipping/pseudo_code.h"

#include <QFile>

namespace app {

namespace {

/// A form's pseudo-code as a page shows it: numbered, in a block.
QString blockOf(std::string_view code)
{
    QString block = QStringLiteral("```\n");
    int number = 0;
    for (const QString& line : shownCode(code))
        block += QStringLiteral("%1  %2\n").arg(++number, 2).arg(line);
    return block + QStringLiteral("```");
}

} // namespace

QString pageOf(const clipping::Algorithm& algorithm)
{
    QFile file(QStringLiteral(":/algorithms/%1.md").arg(latin(algorithm.key)));
    if (!file.open(QIODevice::ReadOnly))
        return QStringLiteral("# %1 (%2)\n\n%3")
            .arg(latin(algorithm.name))
            .arg(algorithm.year)
            .arg(latin(algorithm.idea));
    QString markdown = QString::fromUtf8(file.readAll());
    markdown.replace(QStringLiteral("{published code}"), blockOf(algorithm.publishedCode));
    markdown.replace(QStringLiteral("{corrected code}"), blockOf(algorithm.correctedCode));
    return markdown;
}

QStringList shownCode(std::string_view code)
{
    QStringList lines;
    for (const clipping::CodeLine& line : clipping::linesOf(code))
        lines << latin(line.text);
    return lines;
}

QStringList codeOf(const Variant& variant)
{
    return shownCode(clipping::codeOf(*variant.algorithm, variant.form));
}

} // namespace app

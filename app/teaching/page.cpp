// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/page.h"

#include "app/base/latin.h"

#include <QFile>
#include <QRegularExpression>

namespace app {

namespace {

QStringList linesOf(std::string_view code) { return latin(code).split(u'\n', Qt::SkipEmptyParts); }

/// A form's pseudo-code as a page shows it: numbered, in a block.
QString blockOf(std::string_view code)
{
    QString block = QStringLiteral("```\n");
    int number = 0;
    for (const QString& line : linesOf(code))
        block += QStringLiteral("%1  %2\n").arg(++number, 2).arg(line);
    return block + QStringLiteral("```");
}

} // namespace

AlgorithmPage pageOf(const clipping::Algorithm& algorithm)
{
    QFile file(QStringLiteral(":/algorithms/%1.md").arg(latin(algorithm.key)));
    if (!file.open(QIODevice::ReadOnly))
        return {QStringLiteral("# %1 (%2)\n\n%3")
                    .arg(latin(algorithm.name))
                    .arg(algorithm.year)
                    .arg(latin(algorithm.idea)),
                {}};
    QString markdown = QString::fromUtf8(file.readAll());
    markdown.replace(QStringLiteral("{published code}"), blockOf(algorithm.publishedCode));
    markdown.replace(QStringLiteral("{corrected code}"), blockOf(algorithm.correctedCode));
    return {markdown, pseudoCode(markdown)};
}

QStringList codeOf(const Variant& variant)
{
    const auto code = clipping::codeOf(*variant.algorithm, variant.form);
    return code.empty() ? pageOf(*variant.algorithm).code : linesOf(code);
}

QStringList pseudoCode(const QString& markdown)
{
    static const QRegularExpression numbered(QStringLiteral("^ *(\\d+)(?:  (.*))?$"));
    QStringList code;
    bool inside = false;
    for (const QString& line : markdown.split(u'\n')) {
        if (line.startsWith(QStringLiteral("```"))) {
            if (inside && !code.isEmpty())
                break;
            inside = !inside;
        } else if (const auto match = numbered.match(line);
                   inside && match.hasMatch() && match.captured(1).toInt() == code.size() + 1)
            code << match.captured(2);
    }
    return code;
}

} // namespace app

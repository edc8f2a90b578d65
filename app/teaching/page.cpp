// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/page.h"

#include "app/latin.h"

#include <QFile>
#include <QRegularExpression>

namespace app {

AlgorithmPage pageOf(const clipping::Algorithm& algorithm)
{
    QFile file(QStringLiteral(":/algorithms/%1.md").arg(latin(algorithm.key)));
    if (!file.open(QIODevice::ReadOnly))
        return {QStringLiteral("# %1 (%2)\n\n%3")
                    .arg(latin(algorithm.name))
                    .arg(algorithm.year)
                    .arg(latin(algorithm.idea)),
                {}};
    const QString markdown = QString::fromUtf8(file.readAll());
    return {markdown, pseudoCode(markdown)};
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/named_font.h"

#include "app/lettering/outline_fonts.h"

#include <QFontInfo>
#include <QStringList>

#include <algorithm>

namespace app {
namespace {

/// Names that mean no font in particular; "Sans" is Inkscape's usual one.
const QStringList genericNames{
    QStringLiteral("serif"),      QStringLiteral("sans-serif"),    QStringLiteral("monospace"),
    QStringLiteral("cursive"),    QStringLiteral("fantasy"),       QStringLiteral("system-ui"),
    QStringLiteral("ui-serif"),   QStringLiteral("ui-sans-serif"), QStringLiteral("ui-monospace"),
    QStringLiteral("ui-rounded"), QStringLiteral("math"),          QStringLiteral("sans"),
    QStringLiteral("mono"),       QStringLiteral("inherit")};

/// The names in a list, whose commas may stand in quotation marks.
QStringList namesIn(const QString& list)
{
    QStringList names{QString()};
    QChar quote;
    for (const QChar c : list) {
        const bool isQuote = c == u'"' || c == u'\'';
        if (isQuote && (quote.isNull() || quote == c))
            quote = quote.isNull() ? c : QChar();
        else if (c == u',' && quote.isNull())
            names << QString();
        else
            names.back() += c;
    }
    for (QString& name : names)
        name = name.simplified();
    names.removeAll(QString());
    return names;
}

/// What the system takes for a name that is not installed.
QString systemFont(const QString& name)
{
    const QString family = QFontInfo(QFont(name)).family();
    return outlineFonts().contains(family) ? family : fontInsteadOf(name);
}

} // namespace

NamedFont namedFont(const QString& families)
{
    const QStringList& installed = outlineFonts();
    if (installed.isEmpty())
        return {};
    const QStringList names = namesIn(families);
    for (const QString& name : names) {
        if (genericNames.contains(name, Qt::CaseInsensitive))
            return {systemFont(name), name == names.first() ? QString() : names.first()};
        const auto found = std::ranges::find_if(installed, [&](const QString& family) {
            return family.compare(name, Qt::CaseInsensitive) == 0;
        });
        if (found != installed.end())
            return {*found, name == names.first() ? QString() : names.first()};
    }
    return names.isEmpty() ? NamedFont{systemFont(QStringLiteral("serif")), {}}
                           : NamedFont{systemFont(names.first()), names.first()};
}

} // namespace app

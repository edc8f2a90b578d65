// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/sheet_names.h"

#include "app/base/text.h"

#include <QRegularExpression>

namespace app {
namespace {

// From the first number to the last one.
const QRegularExpression& numbers()
{
    static const QString number = QStringLiteral("\\{(?:row|column|n)\\}");
    static const QRegularExpression all(number + QStringLiteral("(?:.*") + number
                                        + QStringLiteral(")?"));
    return all;
}

QString columnsText(int count)
{
    return count == 1 ? Text::tr("1 column") : Text::tr("%1 columns").arg(count);
}

QString rowsText(int count)
{
    return count == 1 ? Text::tr("1 row") : Text::tr("%1 rows").arg(count);
}

} // namespace

QString gridText(const Tiling& tiling)
{
    return Text::tr("%1 × %2").arg(columnsText(tiling.columns), rowsText(tiling.rows));
}

QString beyondText(const Tiling& tiling)
{
    const auto& [left, top, right, bottom] = tiling.beyond;
    QStringList sides;
    if (left > 0)
        sides << Text::tr("%1 on the left").arg(columnsText(left));
    if (right > 0)
        sides << Text::tr("%1 on the right").arg(columnsText(right));
    if (top > 0)
        sides << Text::tr("%1 above").arg(rowsText(top));
    if (bottom > 0)
        sides << Text::tr("%1 below").arg(rowsText(bottom));
    return sides.empty() ? QString()
                         : Text::tr("Beyond the page: %1.").arg(sides.join(Text::tr(", ")));
}

QString sheetName(const QString& pattern, const Tiling& tiling, const Tile& tile)
{
    QString name = pattern;
    return name.replace(QStringLiteral("{row}"), QString::number(tile.row))
        .replace(QStringLiteral("{column}"), QString::number(tile.column))
        .replace(QStringLiteral("{n}"), QString::number(tiling.numberOf(tile)));
}

bool namesEverySheet(const QString& pattern, const Tiling& tiling)
{
    const auto has = [&](const char* word) { return pattern.contains(QLatin1StringView(word)); };
    return has("{n}")
           || ((tiling.rows == 1 || has("{row}")) && (tiling.columns == 1 || has("{column}")));
}

QString overviewName(const QString& pattern)
{
    QString name = pattern;
    return name.replace(numbers(), QStringLiteral("overview"));
}

QString nameWithoutNumbers(const QString& pattern)
{
    static const QRegularExpression separated(QStringLiteral("[-_ .]*") + numbers().pattern());
    QString name = pattern;
    return name.remove(separated);
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/reading.h"

#include <QLocale>

#include <cmath>

namespace app {

Unit unitOf(const Page& page)
{
    const Unit unit = page.width.unit;
    return infoOf(unit).millimetres > 0 ? unit : Unit::Px;
}

double unitsPerUserUnit(const Page& page, Unit unit)
{
    const double size = infoOf(unit).millimetres;
    return size > 0 ? page.millimetresPerUnit() / size : 1;
}

QString reading(double userUnits, const Page& page, Unit unit, int moreDecimals)
{
    const int decimals = infoOf(unit).decimals + moreDecimals;
    const double value = userUnits * unitsPerUserUnit(page, unit);
    const double least = 0.5 * std::pow(10.0, -decimals);
    QString text =
        QLocale().toString(std::abs(value) < least ? 0.0 : std::abs(value), 'f', decimals);
    return value <= -least ? QChar(0x2212) + text : text;
}

} // namespace app

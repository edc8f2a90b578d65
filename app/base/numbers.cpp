// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"

#include "app/base/text.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

// The magnitude, so that a half is rounded up. People see 31.565, although the nearest double, or a
// difference of two, may be a little less. Adds too little to be seen otherwise.
double withHalfUp(double magnitude, int decimals)
{
    const double step = std::pow(10.0, -decimals);
    const double ulp = std::nextafter(magnitude, HUGE_VAL) - magnitude;
    return std::isfinite(ulp) ? magnitude + std::min(std::max(step * 1e-7, ulp), step * 1e-3)
                              : magnitude;
}

} // namespace

QString withUnit(const QString& number, Unit unit)
{
    const std::string_view suffix = infoOf(unit).suffix;
    if (suffix.empty())
        return number;
    return number + u'\u00a0' + QLatin1StringView(suffix.data(), qsizetype(suffix.size()));
}

QString numberText(double value, int decimals)
{
    const QLocale locale;
    QString text = locale.toString(withHalfUp(std::abs(value), decimals), 'f', decimals);
    const bool zero = text == locale.toString(0.0, 'f', decimals);
    return value < 0 && !zero ? u'\u2212' + text : text;
}

QString shortText(double value, int digits)
{
    return QLocale().toString(value, 'g', digits).replace(u'-', u'\u2212');
}

QString exactText(double value) { return shortText(value, QLocale::FloatingPointShortest); }

QString countText(std::size_t count) { return QLocale().toString(qulonglong(count)); }

QString linesText(std::size_t count)
{
    return count == 1 ? Text::tr("1 line") : Text::tr("%1 lines").arg(countText(count));
}

double inUnit(double userUnits, Unit unit, double millimetresPerUnit)
{
    const double size = infoOf(unit).millimetres;
    return size > 0 ? userUnits * (millimetresPerUnit / size) : userUnits;
}

double fromUnit(double value, Unit unit, double millimetresPerUnit)
{
    const double size = infoOf(unit).millimetres;
    return size > 0 ? value * (size / millimetresPerUnit) : value;
}

QString lengthNumber(double userUnits, Unit unit, double millimetresPerUnit, int more)
{
    return numberText(inUnit(userUnits, unit, millimetresPerUnit), infoOf(unit).decimals + more);
}

QString lengthText(double userUnits, Unit unit, double millimetresPerUnit)
{
    return withUnit(lengthNumber(userUnits, unit, millimetresPerUnit), unit);
}

QString sizeText(const glm::dvec2& size, Unit unit, double millimetresPerUnit)
{
    return lengthNumber(size.x, unit, millimetresPerUnit) + QStringLiteral(" × ")
           + lengthText(size.y, unit, millimetresPerUnit);
}

QString millisecondsText(double milliseconds)
{
    if (milliseconds < 0.01)
        return Text::tr("< %1 ms").arg(numberText(0.01, 2));
    const int decimals = milliseconds < 10 ? 2 : milliseconds < 100 ? 1 : 0;
    return Text::tr("%1 ms").arg(numberText(milliseconds, decimals));
}

QString lateText(double milliseconds)
{
    return Text::tr("%1 s late").arg(numberText(milliseconds / 1000, 1));
}

QString percentText(double share) { return Text::tr("%1 %").arg(numberText(share * 100, 1)); }

namespace {

QString count(double number) { return countText(std::size_t(number)); }

} // namespace

QString durationText(double seconds)
{
    constexpr double minute = 60, hour = 3600;
    if (seconds < 2 * minute)
        return Text::tr("%1 s").arg(count(std::ceil(seconds)));
    if (seconds < 2 * hour)
        return Text::tr("%1 minutes").arg(count(std::round(seconds / minute)));
    return Text::tr("%1 hours").arg(count(std::round(seconds / hour)));
}

QString progressText(const Progress& progress)
{
    const QString share = count(std::floor(100 * progress.share));
    if (progress.share < 0.02) // too early for an estimate
        return Text::tr("%1 %").arg(share);
    return Text::tr("%1 %, %2 left").arg(share, durationText(progress.secondsLeft));
}

} // namespace app

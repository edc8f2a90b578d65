// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/dash_patterns.h"

#include "app/base/number.h"
#include "app/base/numbers.h"
#include "app/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

constexpr double longestDash = 1e9; // as in the fields of the panels
constexpr qsizetype mostDashes = 32;

/// The lengths in a text; a unit after a space belongs to the number before it.
QStringList lengthsIn(QString text, const QLocale& locale)
{
    text.replace(u';', u' ');
    if (locale.decimalPoint() != QStringLiteral(","))
        text.replace(u',', u' ');
    QStringList lengths;
    for (const QString& part : text.simplified().split(u' ', Qt::SkipEmptyParts))
        if (!lengths.isEmpty() && part[0].isLetter())
            lengths.back() += part;
        else
            lengths << part;
    return lengths;
}

Result<double> typedDash(const QString& text, const Scale& scale, const QLocale& locale)
{
    const auto length = typedLength(text, scale, locale);
    if (!length)
        return Result<double>::failure(
            Text::tr("“%1” is not a length: %2.").arg(text, length.error));
    if (*length.value < 0 || *length.value > longestDash)
        return Result<double>::failure(
            Text::tr("“%1” cannot be the length of a dash: type 0 or more.").arg(text));
    return Result<double>::of(fromUnit(*length.value, scale.unit, scale.millimetresPerUnit));
}

} // namespace

std::span<const DashPattern> dashPatterns()
{
    // THE CATALOGUE. To add a pattern, add its row.
    static const std::array all{
        DashPattern{Text::tr("Solid"), {}},
        DashPattern{Text::tr("Dashed"), {6, 3}},
        DashPattern{Text::tr("Dotted"), {1, 2}},
        DashPattern{Text::tr("Dash and dot"), {8, 3, 1, 3}},
        DashPattern{Text::tr("Dash and two dots"), {8, 2, 1, 2, 1, 2}},
        DashPattern{Text::tr("Long dashes"), {14, 4}},
    };
    return all;
}

std::vector<double> scaled(const DashPattern& pattern, double width)
{
    std::vector<double> dashes = pattern.dashes;
    for (double& dash : dashes)
        dash *= width > 0 ? width : 1; // a hairline has dashes, too
    return dashes;
}

std::optional<std::size_t> patternOf(const Style& style)
{
    const auto close = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
    for (std::size_t i = 0; i < dashPatterns().size(); ++i)
        if (std::ranges::equal(style.dashes, scaled(dashPatterns()[i], style.width), close))
            return i;
    return std::nullopt;
}

void setWidth(Style& style, double width)
{
    const auto pattern = style.width > 0 && width > 0 ? patternOf(style) : std::nullopt;
    style.width = width;
    if (pattern)
        style.dashes = scaled(dashPatterns()[*pattern], width);
}

Result<std::vector<double>> typedDashes(const QString& text, const Scale& scale,
                                        const QLocale& locale)
{
    using Dashes = Result<std::vector<double>>;
    std::vector<double> dashes;
    const QStringList lengths = lengthsIn(text, locale);
    if (lengths.size() > mostDashes)
        return Dashes::failure(Text::tr("A dash pattern has at most %1 lengths.").arg(mostDashes));
    for (const QString& length : lengths) {
        const auto dash = typedDash(length, scale, locale);
        if (!dash)
            return Dashes::failure(dash.error);
        dashes.push_back(*dash.value);
    }
    if (!dashes.empty() && std::ranges::all_of(dashes, [](double dash) { return dash == 0; }))
        return Dashes::failure(Text::tr("A dash pattern needs a length greater than 0."));
    return Dashes::of(std::move(dashes));
}

QString dashesText(std::span<const double> dashes, const Scale& scale)
{
    constexpr int decimals = 4;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    QStringList parts;
    for (const double dash : dashes) {
        const double value = inUnit(dash, scale.unit, scale.millimetresPerUnit);
        QString number = locale.toString(value, 'f', decimals);
        while (number.endsWith(u'0'))
            number.chop(1);
        if (number.endsWith(locale.decimalPoint()))
            number.chop(locale.decimalPoint().size());
        parts << number;
    }
    if (const auto suffix = infoOf(scale.unit).suffix; !dashes.empty() && !suffix.empty())
        parts << latin(suffix);
    return parts.join(u' ');
}

} // namespace app

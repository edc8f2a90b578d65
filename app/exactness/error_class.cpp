// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exactness/error_class.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/comparison/ulps.h"
#include "app/view/visible_colour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace app {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Two decimals below one, "< 0.01" for less.
QString number(double ulps)
{
    return ulps > 0 && ulps < 0.005 ? QStringLiteral("< 0.01")
           : ulps > 0 && ulps < 1   ? numberText(ulps, 2)
                                    : ulpsText(ulps);
}

QString rightText(const Variant& variant, const ErrorCounts& counts)
{
    const std::size_t wrong = counts.classes.back(), all = counts.all();
    if (wrong == 0 && all == 1)
        return Text::tr("%1 is right about the only visible line").arg(nameOf(variant));
    if (wrong == 0)
        return Text::tr("%1 is right about all %2 visible lines")
            .arg(nameOf(variant), countText(all));
    return Text::tr("%1 is wrong about %2 of %3 visible lines")
        .arg(nameOf(variant), countText(wrong), countText(all));
}

QStringList wrongTexts(const ErrorCounts& counts)
{
    QStringList texts;
    const auto add = [&](std::size_t count, const QString& text) {
        if (count > 0)
            texts << text.arg(countText(count));
    };
    add(counts.lost, Text::tr("%1 lost"));
    add(counts.invented, Text::tr("%1 shown but not visible"));
    add(counts.notFinite, Text::tr("%1 with an end that is not a number"));
    add(counts.outside, Text::tr("%1 with an end outside the window"));
    return texts;
}

} // namespace

std::span<const ErrorClass> errorClasses()
{
    static const std::array all{ErrorClass{0, Text::tr("exact"), false},
                                ErrorClass{0.5, Text::tr("≤ ½ ulp"), false},
                                ErrorClass{1, Text::tr("≤ 1 ulp"), false},
                                ErrorClass{4, Text::tr("≤ 4 ulps"), false},
                                ErrorClass{16, Text::tr("≤ 16 ulps"), false},
                                ErrorClass{64, Text::tr("≤ 64 ulps"), false},
                                ErrorClass{unlimited, Text::tr("more"), false},
                                ErrorClass{unlimited, Text::tr("wrong"), true}};
    return all;
}

std::size_t errorClassOf(const LineExactness& line, ErrorUnit errorUnit)
{
    const auto all = errorClasses();
    if (line.isWrong())
        return all.size() - 1;
    const double error = errorOf(line, errorUnit);
    std::size_t row = 0;
    while (error > all[row].most)
        ++row;
    return row;
}

QColor errorColour(std::size_t errorClass, Ground ground, const QColor& wrong)
{
    const std::size_t last = errorClasses().size() - 1;
    if (errorClass == last)
        return wrong;
    constexpr double palest = 0.3; // so that thin lines are visible
    return sequentialColour(palest + (1 - palest) * double(errorClass) / double(last - 1), ground);
}

std::size_t ErrorCounts::all() const
{
    return std::accumulate(classes.begin(), classes.end(), std::size_t(0));
}

ErrorCounts counted(const ExactnessResults& results, ErrorUnit errorUnit)
{
    ErrorCounts counts;
    counts.classes.resize(errorClasses().size());
    for (const LineExactness& line : results.list) {
        ++counts.classes[errorClassOf(line, errorUnit)];
        counts.lost += line.fault == Fault::Lost;
        counts.invented += line.fault == Fault::Invented;
        counts.notFinite += line.fault == Fault::NotFinite;
        counts.outside += line.outside();
        counts.orderMatters += line.orderMatters;
        if (line.fault == Fault::None)
            counts.worst = std::max(counts.worst, errorOf(line, errorUnit));
    }
    return counts;
}

QString errorText(double ulps)
{
    return ulps == 1 ? Text::tr("1 ulp") : Text::tr("%1 ulps").arg(number(ulps));
}

QString sentence(const Variant& variant, const ErrorCounts& counts, ErrorUnit errorUnit)
{
    if (counts.all() == 0)
        return Text::tr("Nothing is visible here.");
    QString text = rightText(variant, counts);
    if (const QStringList wrong = wrongTexts(counts); !wrong.isEmpty())
        text += QStringLiteral(": ") + wrong.join(Text::tr(", "));
    text += Text::tr(". The worst end is off by %1 of %2")
                .arg(errorText(counts.worst), errorUnit == ErrorUnit::Largest
                                                  ? Text::tr("the largest coordinate")
                                                  : Text::tr("its own coordinate"));
    text += counts.orderMatters == 0
                ? Text::tr("; no result depends on the order of the ends.")
                : Text::tr("; results that depend on the order of the ends: %1.")
                      .arg(countText(counts.orderMatters));
    return text;
}

QString verdictText(const LineExactness& line)
{
    QStringList texts;
    switch (line.fault) {
    case Fault::Lost:
        texts << (line.lost == 0 ? Text::tr("lost: a point")
                                 : Text::tr("lost: %1").arg(errorText(line.lost)));
        break;
    case Fault::Invented:
        texts << (line.lost == 0 ? Text::tr("shown but not visible: a point")
                                 : Text::tr("shown but not visible: %1").arg(errorText(line.lost)));
        break;
    case Fault::NotFinite:
        texts << Text::tr("an end is not a number");
        break;
    case Fault::None:
        break;
    }
    if (line.outside())
        texts << Text::tr("outside the window");
    if (line.orderMatters)
        texts << Text::tr("depends on the order of the ends");
    return texts.isEmpty() ? Text::tr("right") : texts.join(Text::tr(", "));
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/race/race_lane.h"

#include "app/base/numbers.h"
#include "app/base/text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

struct TimeUnit {
    const char* name;
    double milliseconds;
};

constexpr std::array units{TimeUnit{QT_TRANSLATE_NOOP("Text", "s"), 1e3},
                           TimeUnit{QT_TRANSLATE_NOOP("Text", "ms"), 1},
                           TimeUnit{QT_TRANSLATE_NOOP("Text", "µs"), 1e-3},
                           TimeUnit{QT_TRANSLATE_NOOP("Text", "ns"), 1e-6}};
constexpr double nearly = 1 - 1e-9; // powers of ten may be off by rounding
constexpr double almostAll = 0.9;   // of a shorter lane: it would soon be too short again
constexpr double justMore = 1.001;  // leads to the next longer lane

const TimeUnit& unitOf(double most)
{
    const auto found = std::ranges::find_if(
        units, [most](const TimeUnit& unit) { return most >= unit.milliseconds * nearly; });
    return most <= 0 ? units[1] : found == units.end() ? units.back() : *found;
}

/// The smallest of 1, 2, 5 × 10ⁿ that is not less.
double roundedUp(double number)
{
    const double power = std::pow(10, std::floor(std::log10(number)));
    for (const double factor : {1., 2., 5.})
        if (number <= factor * power)
            return factor * power;
    return 10 * power;
}

/// Of a number with so many significant digits.
int decimalsOf(double number, int digits)
{
    if (number <= 0)
        return 0;
    const auto needed = [digits](double of) {
        return std::max(0, digits - 1 - int(std::floor(std::log10(of))));
    };
    const int decimals = needed(number);
    const double rounded = number + 0.5 * std::pow(10, -decimals); // 9.996 becomes 10.0
    return std::min(decimals, needed(rounded));
}

} // namespace

QString RaceLane::unit() const { return Text::tr(unitOf(most).name); }

QString RaceLane::number(double milliseconds, int digits) const
{
    const double value = milliseconds / unitOf(most).milliseconds;
    return numberText(value, decimalsOf(value, digits));
}

QString RaceLane::text(double milliseconds, int digits) const
{
    return Text::tr("%1 %2", "a number and its unit").arg(number(milliseconds, digits), unit());
}

QString RaceLane::end() const { return text(most, 1); }

double RaceLane::share(double milliseconds) const
{
    return most > 0 ? std::clamp(milliseconds / most, 0.0, 1.0) : 0;
}

RaceLane laneOf(std::span<const RacePair> pairs, const RaceLane& before)
{
    double longest = 0;
    for (const RacePair& pair : pairs)
        for (const auto& form : {pair.corrected, pair.published})
            if (form)
                longest = std::max(longest, form->summary.median);
    if (longest <= 0)
        return {};
    const double most = roundedUp(longest);
    // Only the next longer scale: a longer one is of an outlier, or of another place.
    const bool isNext = most < before.most && roundedUp(most * justMore) == before.most;
    return isNext && longest > almostAll * most ? before : RaceLane{most};
}

} // namespace app

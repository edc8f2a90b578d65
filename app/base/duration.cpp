// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/duration.h"

#include "app/base/numbers.h"
#include "app/base/text.h"

#include <cmath>

namespace app {
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

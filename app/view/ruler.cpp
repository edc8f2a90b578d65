// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/ruler.h"

#include <algorithm>
#include <cmath>

namespace app {

constexpr double betweenNumbers = 64, betweenTicks = 4; // pixels
constexpr double mostTicks = 10'000;

std::vector<Tick> ticks(double from, double to, double pixels)
{
    if (!(pixels > 0) || !(to > from) || !std::isfinite(to - from))
        return {};
    const double decade = std::pow(10, std::floor(std::log10(betweenNumbers / pixels)));
    double step = decade;
    for (const double factor : {2.0, 5.0, 10.0})
        if (step * pixels < betweenNumbers)
            step = decade * factor;
    const int parts = step * pixels / 10 >= betweenTicks ? 10 : 5;
    const double fine = step / parts;
    std::vector<Tick> all;
    if ((to - from) / fine > mostTicks)
        return all;
    const double first = std::ceil(from / fine);
    for (int count = 0; count <= mostTicks && (first + count) * fine <= to; ++count) {
        const double i = first + count, rest = std::fmod(std::abs(i), parts);
        const auto rank = rest == 0                  ? Tick::Rank::Numbered
                          : parts == 10 && rest == 5 ? Tick::Rank::Half
                                                     : Tick::Rank::Fine;
        all.push_back({i / parts * step, rank});
    }
    return all;
}

} // namespace app

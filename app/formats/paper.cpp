// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/paper.h"

#include "app/base/text.h"

#include <cmath>

namespace app {

Paper paperOf(const Page& page)
{
    const double unit = page.millimetresPerUnit();
    const auto size = [&](Length length, double units) { // in user units
        const double ratio = infoOf(length.unit).millimetres / unit;
        return length.value * ratio > 0 ? length.value * ratio
                                        : units; // an open size equals that of the page
    };
    const Point paper{size(page.width, page.size.x), size(page.height, page.size.y)};
    return {paper * unit, unit, page.min - (paper - page.size) / 2.0};
}

std::optional<QString> faultOf(const Page& page)
{
    constexpr double smallestUnit = 1e-100, largestUnit = 1e100; // millimetres
    constexpr double largest = 1e300;                            // which readers accept
    const double unit = page.millimetresPerUnit();
    const auto fits = [&](double min, double size, const Length& length) {
        const double paper = size * unit;
        return size > 0 && size <= largest && paper > 0 && paper <= largest
               && std::abs(min) <= largest && std::abs(min) * unit <= largest
               && std::abs(length.value) <= largest;
    };
    if (unit >= smallestUnit && unit <= largestUnit && fits(page.min.x, page.size.x, page.width)
        && fits(page.min.y, page.size.y, page.height))
        return std::nullopt;
    return Text::tr("the page is too large or too small to calculate with. Its width, height and "
                    "view box must give a unit between 1e-100 mm and 1e100 mm.");
}

} // namespace app

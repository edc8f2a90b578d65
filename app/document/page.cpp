// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/page.h"

namespace app {

double Page::millimetresPerUnit() const
{
    const auto scale = [](Length length, double units) {
        const double unit = infoOf(length.unit).millimetres; // dividing lengths first makes 1000 px
                                                             // / 1000 exactly 1
        return units > 0 && length.value > 0 ? unit * (length.value / units) : 0.0;
    };
    const double x = scale(width, size.x), y = scale(height, size.y);
    if (x > 0 && y > 0)
        return x < y ? x : y; // as SVG's "meet"
    return x > 0 ? x : y > 0 ? y : infoOf(Unit::Px).millimetres;
}

Unit Page::usualUnit() const { return infoOf(width.unit).millimetres > 0 ? width.unit : Unit::Px; }

} // namespace app

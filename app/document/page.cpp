// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/page.h"

namespace app {

/// Lengths are multiplied and divided before their unit: 1000 px / 1000 are exactly 1, and so are
/// 297 mm * 50 / 14850.
static double sizeOfUnit(const Page& page, double ratio)
{
    const auto scale = [ratio](Length length, double units) {
        const double unit = infoOf(length.unit).millimetres;
        return units > 0 && length.value > 0 ? unit * (length.value * ratio / units) : 0.0;
    };
    const double x = scale(page.width, page.size.x), y = scale(page.height, page.size.y);
    if (x > 0 && y > 0)
        return x < y ? x : y; // as SVG's "meet"
    return x > 0 ? x : y > 0 ? y : infoOf(Unit::Px).millimetres * ratio;
}

double Page::millimetresPerUnit() const { return sizeOfUnit(*this, 1); }

double Page::realMillimetresPerUnit() const { return sizeOfUnit(*this, scale.ratio); }

Unit Page::usualUnit() const
{
    return scale.unit ? *scale.unit : infoOf(width.unit).millimetres > 0 ? width.unit : Unit::Px;
}

Unit Page::paperUnit(Unit unit) const
{
    if (unit == Unit::Foot)
        return Unit::Inch;
    return unit == Unit::Metre || (unit == Unit::Cm && scale.ratio != 1) ? Unit::Mm : unit;
}

} // namespace app

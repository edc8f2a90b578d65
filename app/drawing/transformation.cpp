// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/transformation.h"

#include "app/base/text.h"
#include "app/drawing/transformation_measures.h"

#include <array>
#include <cmath>

namespace app {
namespace {

AffineMap move(const GestureStart& start, const GestureEnd& end, Along, double times)
{
    return translation((end.point - start.from) * times);
}

AffineMap rotate(const GestureStart& start, const GestureEnd& end, Along, double times)
{
    return rotation(end.numbers[0] * times, start.from);
}

AffineMap scale(const GestureStart& start, const GestureEnd& end, Along axis, double times)
{
    const double factor = std::pow(end.numbers[0], times);
    return scaling({axis == Along::Y ? 1 : factor, axis == Along::X ? 1 : factor}, start.from);
}

AffineMap skew(const GestureStart& start, const GestureEnd& end, Along axis, double times)
{
    const double degrees = end.numbers[0] * times;
    return axis == Along::Y ? verticalSkew(degrees, start.from)
                            : horizontalSkew(degrees, start.from);
}

} // namespace

std::span<const Transformation> transformations()
{
    static const std::array all{
        Transformation{"move", u'G', Text::tr("&Move"), Text::tr("Move selection"),
                       Text::tr("Select what to move first, with the Select tool (V)."),
                       moveMeasure, move, true},
        Transformation{"rotate", u'O', Text::tr("&Rotate"), Text::tr("Rotate selection"),
                       Text::tr("Select what to rotate first, with the Select tool (V)."),
                       rotationMeasure, rotate},
        Transformation{"scale", u'K', Text::tr("&Scale"), Text::tr("Scale selection"),
                       Text::tr("Select what to scale first, with the Select tool (V)."),
                       scalingMeasure, scale},
        Transformation{"skew", u'J', Text::tr("S&kew"), Text::tr("Skew selection"),
                       Text::tr("Select what to skew first, with the Select tool (V)."),
                       skewMeasure, skew},
    };
    return all;
}

const Transformation* findTransformation(std::string_view key)
{
    const auto all = transformations();
    const auto found = std::ranges::find(all, key, &Transformation::key);
    return found == all.end() ? nullptr : &*found;
}

} // namespace app

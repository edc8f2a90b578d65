// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/transformation.h"

#include "app/base/text.h"
#include "app/document/direction.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

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
                       Text::tr("Select what to move first, with the Select tool ({tool-select})."),
                       moveMeasure, move, true},
        Transformation{
            "rotate", u'O', Text::tr("&Rotate"), Text::tr("Rotate selection"),
            Text::tr("Select what to rotate first, with the Select tool ({tool-select})."),
            rotationMeasure, rotate},
        Transformation{
            "scale", u'K', Text::tr("&Scale"), Text::tr("Scale selection"),
            Text::tr("Select what to scale first, with the Select tool ({tool-select})."),
            scalingMeasure, scale},
        Transformation{"skew", u'J', Text::tr("S&kew"), Text::tr("Skew selection"),
                       Text::tr("Select what to skew first, with the Select tool ({tool-select})."),
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

namespace {

using Points = GestureMeasure::Points;

constexpr double turnStep = 15; // degrees

template <int axis>
GestureMeasure wayAlong(const QString& name)
{
    return {{{name, Quantity::Coordinate}},
            [](const GestureStart& start, const Point& to) -> Numbers {
                return {to[axis] - start.from[axis], 0};
            },
            [](const GestureStart& start, const Point& pointer, const Held& held) {
                Point end = start.from;
                end[axis] = held[0] ? start.from[axis] + *held[0] : pointer[axis];
                return end;
            },
            Points::Relative};
}

double angleBetween(const GestureStart& start, const Point& to)
{
    const double turned = degreesOf(to - start.from) - degreesOf(start.pointer - start.from);
    return std::remainder(turned, 360);
}

/// The quotient of two vectors along a direction; 1 if the first one has no length.
double quotient(const Point& old, const Point& now)
{
    const double square = glm::dot(old, old);
    if (square == 0)
        return 1;
    const double factor = glm::length(now) / std::sqrt(square);
    return glm::dot(old, now) < 0 ? -factor : factor;
}

template <Along axis>
GestureMeasure scalingAlong()
{
    const auto values = [](const GestureStart& start, const Point& to) -> Numbers {
        const Point only(axis == Along::Y ? 0 : 1, axis == Along::X ? 0 : 1);
        return {quotient((start.pointer - start.from) * only, (to - start.from) * only), 0};
    };
    const auto end = [](const GestureStart& start, const Point& pointer, const Held& held) {
        return held[0] ? start.from + (start.pointer - start.from) * *held[0] : pointer;
    };
    const QString name = axis == Along::X   ? Text::tr("Scale X")
                         : axis == Along::Y ? Text::tr("Scale Y")
                                            : Text::tr("Scale");
    return {{{name, Quantity::Factor}}, values, end, Points::Refused};
}

/// `along`: the coordinate in which points move.
template <int along>
double skewAngle(const GestureStart& start, const Point& to)
{
    const double height =
        along == 0 ? start.from.y - start.pointer.y : start.pointer.x - start.from.x;
    const double way = along == 0 ? to.x - start.pointer.x : start.pointer.y - to.y;
    if (height == 0)
        return 0;
    return std::clamp(glm::degrees(std::atan(way / height)), -mostSkew, mostSkew);
}

template <int along>
Point skewed(const GestureStart& start, double degrees)
{
    return along == 0 ? horizontalSkew(degrees, start.from)(start.pointer)
                      : verticalSkew(degrees, start.from)(start.pointer);
}

template <int along>
GestureMeasure skewAlong(const QString& name)
{
    const auto values = [](const GestureStart& start, const Point& to) -> Numbers {
        return {skewAngle<along>(start, to), 0};
    };
    const auto end = [](const GestureStart& start, const Point& pointer, const Held& held) {
        return held[0] ? skewed<along>(start, *held[0]) : pointer;
    };
    const auto toStep = [](const GestureStart& start, const Point& pointer) {
        const double steps = std::round(skewAngle<along>(start, pointer) / turnStep);
        constexpr double most = 90 / turnStep - 1; // a right angle has no skew
        return skewed<along>(start, std::clamp(steps, -most, most) * turnStep);
    };
    return {{{name, Quantity::Angle, mostSkew}}, values, end, Points::Refused, toStep};
}

} // namespace

const GestureMeasure& moveMeasure(Along axis)
{
    static const GestureMeasure x = wayAlong<0>(Text::tr("X")), y = wayAlong<1>(Text::tr("Y"));
    return axis == Along::X ? x : axis == Along::Y ? y : lengthAndAngle();
}

const GestureMeasure& rotationMeasure(Along)
{
    static const GestureMeasure measure{
        {{Text::tr("Angle"), Quantity::Angle}},
        [](const GestureStart& start, const Point& to) -> Numbers {
            return {angleBetween(start, to), 0};
        },
        [](const GestureStart& start, const Point& pointer, const Held& held) {
            return held[0] ? turnedPointer(start, *held[0]) : pointer;
        },
        Points::Refused,
        [](const GestureStart& start, const Point& pointer) {
            return turnedPointer(start,
                                 std::round(angleBetween(start, pointer) / turnStep) * turnStep);
        }};
    return measure;
}

const GestureMeasure& scalingMeasure(Along axis)
{
    static const GestureMeasure both = scalingAlong<Along::Both>(), x = scalingAlong<Along::X>(),
                                y = scalingAlong<Along::Y>();
    return axis == Along::X ? x : axis == Along::Y ? y : both;
}

const GestureMeasure& skewMeasure(Along axis)
{
    static const GestureMeasure x = skewAlong<0>(Text::tr("Skew X")),
                                y = skewAlong<1>(Text::tr("Skew Y"));
    return axis == Along::Y ? y : x;
}

} // namespace app

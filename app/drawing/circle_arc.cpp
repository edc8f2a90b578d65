// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/circle_arc.h"

#include "app/base/text.h"
#include "app/document/affine_map.h"
#include "app/document/arc_curves.h"
#include "app/document/direction.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double least = 1e-7; // degrees; a flatter arc is a line

} // namespace

// The chord is seen from every point of the arc at the same angle.
std::optional<CircleArc> arcThrough(const Point& from, const Point& to, const Point& on)
{
    const Point a = from - on, b = to - on;
    const double turn = cross(a, b);
    const double degrees = 360 - 2 * glm::degrees(std::atan2(std::abs(turn), glm::dot(a, b)));
    if (from == to || on == from || on == to || degrees < least || degrees > 360 - least)
        return std::nullopt;
    return arcOfAngle(from, to, turn > 0 ? degrees : -degrees);
}

CircleArc arcOfAngle(const Point& from, const Point& to, double degrees)
{
    const Point half = (to - from) * 0.5;
    const double slope = std::abs(degrees) == 180 ? 0 : 1 / std::tan(glm::radians(degrees / 2));
    return {from + half + Point(half.y, -half.x) * slope, from, to, degrees};
}

CircleArc arcAround(const Point& centre, const Point& from, double degrees)
{
    return {centre, from, rotation(degrees, centre)(from), degrees};
}

double radiusOf(const CircleArc& arc) { return glm::distance(arc.centre, arc.from); }

Point middleOf(const CircleArc& arc)
{
    const Point half = (arc.to - arc.from) * 0.5;
    if (std::abs(arc.degrees) > 270) // where the ends are too near to each other for the formula
        return rotation(arc.degrees / 2, arc.centre)(arc.from);
    return arc.from + half + Point(-half.y, half.x) * std::tan(glm::radians(arc.degrees / 4));
}

Subpath pathOf(const CircleArc& arc)
{
    const double radius = radiusOf(arc);
    const bool whole = std::abs(arc.degrees) == 360;
    Subpath path{arc.from, {}, whole};
    const EllipseArc circle{arc.centre,
                            {radius, 0},
                            {0, radius},
                            -glm::radians(degreesOf(arc.from - arc.centre)),
                            -glm::radians(arc.degrees)};
    appendCurves(path.segments, circle, arc.from, whole ? arc.from : arc.to);
    return path;
}

namespace {

constexpr double arcStep = 15, whole = 360; // degrees
constexpr double most = 359;                // of an arc between two points
constexpr double rounding = 1e-12;          // relative to the radius

double chordOf(const GestureStart& start) { return glm::distance(start.from, start.pointer); }

/// 1: an arc on the pointer's side of the chord goes counterclockwise. −1: clockwise.
int sideOf(const GestureStart& start, const Point& pointer)
{
    const Point chord = start.pointer - start.from, way = pointer - start.from;
    return cross(chord, way) < 0 ? -1 : 1;
}

/// The angle of the arc with this radius: the larger arc, if the pointer is on one.
double angleOf(const GestureStart& start, const Point& pointer, double radius)
{
    const double share = chordOf(start) / (2 * radius);
    const double degrees = share < 1 - rounding ? 2 * glm::degrees(std::asin(share)) : 180;
    const auto aimed = arcThrough(start.from, start.pointer, pointer);
    return aimed && std::abs(aimed->degrees) > 180 ? whole - degrees : degrees;
}

Point onArc(const GestureStart& start, const Point& pointer, double degrees)
{
    return degrees == 0
               ? pointer
               : middleOf(arcOfAngle(start.from, start.pointer, degrees * sideOf(start, pointer)));
}

Numbers arcValues(const GestureStart& start, const Point& on)
{
    const auto arc = arcThrough(start.from, start.pointer, on);
    return arc ? Numbers{radiusOf(*arc), std::abs(arc->degrees)} : Numbers{HUGE_VAL, 0};
}

Point endOfArc(const GestureStart& start, const Point& pointer, const Held& held)
{
    if (held[1])
        return onArc(start, pointer, *held[1]);
    return held[0] && *held[0] > 0 ? onArc(start, pointer, angleOf(start, pointer, *held[0]))
                                   : pointer;
}

QString refusalOfArc(const GestureStart& start, const Held& held)
{
    if (held[0] && *held[0] < chordOf(start) / 2 * (1 - rounding))
        return Text::tr("The radius must be at least half the distance between the ends.");
    return held[1] == 0 ? Text::tr("The angle must not be 0.") : QString();
}

template <Turn turn>
double sweepOf(const GestureStart& start, const Point& to)
{
    const double degrees = degreesOf(to - start.from) - degreesOf(start.pointer - start.from);
    if (turn == Turn::Counterclockwise)
        return degrees < 0 ? degrees + whole : degrees;
    return degrees > 0 ? degrees - whole : degrees;
}

template <Turn turn>
GestureMeasure sweep()
{
    return {{{Text::tr("Angle"), Quantity::Angle, whole}},
            [](const GestureStart& start, const Point& to) -> Numbers {
                return {sweepOf<turn>(start, to)};
            },
            [](const GestureStart& start, const Point& pointer, const Held& held) {
                return held[0] ? turnedPointer(start, *held[0]) : pointer;
            },
            GestureMeasure::Points::Relative,
            [](const GestureStart& start, const Point& pointer) {
                return turnedPointer(start,
                                     std::round(sweepOf<turn>(start, pointer) / arcStep) * arcStep);
            },
            false,
            [](const GestureStart&, const Held& held) {
                return held[0] == 0 ? Text::tr("The angle must not be 0.") : QString();
            }};
}

} // namespace

const GestureMeasure& arcMeasure()
{
    static const GestureMeasure measure{
        {{Text::tr("Radius"), Quantity::Length}, {Text::tr("Angle"), Quantity::Angle, most}},
        arcValues,
        endOfArc,
        GestureMeasure::Points::Relative,
        [](const GestureStart& start, const Point& pointer) {
            const double degrees = std::round(arcValues(start, pointer)[1] / arcStep) * arcStep;
            return onArc(start, pointer, std::clamp(degrees, arcStep, whole - arcStep));
        },
        true,
        refusalOfArc};
    return measure;
}

const GestureMeasure& sweepMeasure(Turn turn)
{
    static const GestureMeasure counterclockwise = sweep<Turn::Counterclockwise>(),
                                clockwise = sweep<Turn::Clockwise>();
    return turn == Turn::Clockwise ? clockwise : counterclockwise;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/circle_arc.h"

#include "app/document/affine_map.h"
#include "app/document/arc_curves.h"
#include "app/document/direction.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

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

} // namespace app

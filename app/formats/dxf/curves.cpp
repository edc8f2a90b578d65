// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app::dxf {
namespace {

constexpr double wholeTurn = 2 * std::numbers::pi;
constexpr double sameAngle = 1e-9;

// The angles between begin and end at which the arc is farthest to a side, in its order.
std::vector<double> farthestAngles(const EllipseArc& arc)
{
    const double low = std::min(arc.angle, arc.angle + arc.sweep) + sameAngle;
    const double high = std::max(arc.angle, arc.angle + arc.sweep) - sameAngle;
    std::vector<double> angles;
    for (const int axis : {0, 1}) {
        const double base = std::atan2(arc.axis2[axis], arc.axis1[axis]);
        constexpr double halfTurn = std::numbers::pi;
        for (double t = base + std::ceil((low - base) / halfTurn) * halfTurn; t < high;
             t += halfTurn)
            angles.push_back(t);
    }
    std::ranges::sort(angles);
    if (arc.sweep < 0)
        std::ranges::reverse(angles);
    return angles;
}

glm::dvec3 leftOf(const glm::dvec3& v) { return {-v.y, v.x, 0}; }

// The arc of a bulge from one corner to another, in the plane of the polyline.
void appendBulge(Subpath& path, const Corner& from, const glm::dvec3& to, const Space& space)
{
    const double bulge = from.bulge;
    const glm::dvec3 chord = to - from.at;
    const glm::dvec3 centre =
        (from.at + to) / 2.0 + leftOf(chord) * ((1 - bulge * bulge) / (4 * bulge));
    const glm::dvec3 radius = from.at - centre;
    EllipseArc arc = arcOnPage(space, centre, {radius.x, radius.y, 0}, leftOf(radius));
    arc.sweep = 4 * std::atan(bulge);
    appendArc(path, arc, onPage(space(to)));
}

} // namespace

EllipseArc arcOnPage(const Space& space, const glm::dvec3& centre, const glm::dvec3& axis1,
                     const glm::dvec3& axis2)
{
    return {onPage(space(centre)), onPage(space.direction(axis1)), onPage(space.direction(axis2))};
}

void appendArc(Subpath& path, const EllipseArc& arc, const Point& to)
{
    const auto end = [&] { return path.segments.empty() ? path.start : path.segments.back().to; };
    EllipseArc part = arc;
    for (const double angle : farthestAngles(arc)) {
        part.sweep = angle - part.angle;
        if (std::abs(part.sweep) < sameAngle)
            continue;
        appendCurves(path.segments, part, end(), arc.at(angle));
        part.angle = angle;
    }
    part.sweep = arc.angle + arc.sweep - part.angle;
    appendCurves(path.segments, part, end(), to);
}

Subpath pathOf(const EllipseArc& arc)
{
    Subpath path{arc.at(arc.angle), {}, std::abs(arc.sweep) > wholeTurn - sameAngle};
    appendArc(path, arc, path.closed ? path.start : arc.at(arc.angle + arc.sweep));
    return path;
}

Subpath pathOf(const std::vector<Corner>& corners, bool closed, const Space& space)
{
    constexpr double straight = 1e-12;
    if (corners.empty())
        return {};
    Subpath path{onPage(space(corners.front().at)), {}, closed && corners.size() > 1};
    path.segments.reserve(corners.size());
    for (std::size_t i = 0; i + 1 < corners.size() + (path.closed ? 1 : 0); ++i) {
        const glm::dvec3& to = corners[(i + 1) % corners.size()].at;
        const bool closes = i + 1 == corners.size();
        if (std::abs(corners[i].bulge) > straight && to != corners[i].at)
            appendBulge(path, corners[i], to, space);
        else if (!closes) // the path closes itself by a line
            path.segments.push_back({onPage(space(to))});
    }
    return path;
}

} // namespace app::dxf

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/write_arcs.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace app::dxf::writing {
namespace {

constexpr double fullTurn = 2 * std::numbers::pi;
constexpr double strayOfArc = 6e-4;  // of the radius: how far Bézier curves are from an arc
constexpr double nearFullTurn = 0.1; // radians; the ends then hardly say where the centre is
constexpr double leastSweep = 1e-6;  // radians

struct CurveOf {
    Bezier curve;
    std::optional<EllipseArc> ellipse;
};

Point turnedLeft(const Point& v) { return {-v.y, v.x}; }

std::vector<CurveOf> curvesOf(const Subpath& path)
{
    std::vector<CurveOf> all;
    Point at = path.start;
    for (const auto& [to, control1, control2, curved] : path.segments) {
        CurveOf next{{at, control1, control2, to}, std::nullopt};
        if (curved)
            next.ellipse = ellipseOf(next.curve);
        all.push_back(next);
        at = to;
    }
    return all;
}

/// With the axes of a circle, if that is what it is but for rounding.
EllipseArc asCircle(EllipseArc arc)
{
    const double a = glm::length(arc.axis1), b = glm::length(arc.axis2);
    const bool round = std::abs(a - b) <= strayOfArc * a
                       && std::abs(glm::dot(arc.axis1, arc.axis2)) <= strayOfArc * a * a;
    if (round)
        arc.axis2 =
            cross(arc.axis1, arc.axis2) > 0 ? turnedLeft(arc.axis1) : -turnedLeft(arc.axis1);
    return arc;
}

/// The way from the centre, in the axes of the ellipse: on it the length is 1.
Point wayFrom(const EllipseArc& arc, const Point& p)
{
    const double all = cross(arc.axis1, arc.axis2);
    const Point way = p - arc.centre;
    return {cross(way, arc.axis2) / all, cross(arc.axis1, way) / all};
}

/// The angle of a curve as seen from the centre, if it lies on the ellipse.
std::optional<double> sweepOn(const EllipseArc& arc, const Bezier& curve)
{
    Point last = wayFrom(arc, curve.from);
    double sweep = 0;
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Point next = wayFrom(arc, curve.at(t));
        if (!(std::abs(glm::length(next) - 1) <= strayOfArc))
            return std::nullopt;
        const double turn = std::atan2(cross(last, next), glm::dot(last, next));
        if (turn * sweep < 0)
            return std::nullopt;
        sweep += turn;
        last = next;
    }
    return sweep;
}

/// The arc with these ends and this angle, on an ellipse of the same form.
EllipseArc through(const EllipseArc& form, const Point& from, const Point& to, double sweep)
{
    const Point a = wayFrom(form, from), b = wayFrom(form, to);
    const Point chord = b - a, middle = (a + b) * 0.5;
    const Point centre = middle + turnedLeft(chord) * (0.5 / std::tan(sweep / 2));
    const double radius = glm::distance(centre, a);
    return {form.centre + form.axis1 * centre.x + form.axis2 * centre.y, form.axis1 * radius,
            form.axis2 * radius, std::atan2(a.y - centre.y, a.x - centre.x), sweep};
}

} // namespace

bool isCircle(const EllipseArc& arc)
{
    return arc.axis2 == turnedLeft(arc.axis1) || arc.axis2 == -turnedLeft(arc.axis1);
}

std::optional<EllipseArc> singleArcOf(const Subpath& path)
{
    const auto all = curvesOf(path);
    const auto sizeOf = [](const CurveOf& one) { return one.ellipse ? one.ellipse->sweep : 0; };
    const auto longest = std::ranges::max_element(all, {}, sizeOf);
    if (longest == all.end() || !longest->ellipse)
        return std::nullopt;
    const EllipseArc form = asCircle(*longest->ellipse);
    double sweep = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto part = path.segments[i].curved ? sweepOn(form, all[i].curve) : std::nullopt;
        if (!part || *part * sweep < 0)
            return std::nullopt;
        sweep += *part;
    }
    const Point& end = path.segments.back().to;
    if (end == path.start && std::abs(std::abs(sweep) - fullTurn) < nearFullTurn) {
        const Point begin = wayFrom(form, path.start);
        return EllipseArc{form.centre, form.axis1, form.axis2, std::atan2(begin.y, begin.x),
                          std::copysign(fullTurn, sweep)};
    }
    if (path.closed || std::abs(sweep) > fullTurn - nearFullTurn || std::abs(sweep) < leastSweep)
        return std::nullopt;
    return through(form, path.start, end, sweep);
}

std::vector<std::optional<double>> bulgesOf(const Subpath& path)
{
    const auto all = curvesOf(path);
    std::vector<std::optional<double>> bulges;
    // A curve too short to tell its circle may be on that of its neighbour.
    const auto bulgeOn = [&](std::size_t i, std::size_t of) -> std::optional<double> {
        if (of >= all.size() || !all[of].ellipse)
            return std::nullopt;
        const EllipseArc form = asCircle(*all[of].ellipse);
        const auto sweep = isCircle(form) ? sweepOn(form, all[i].curve) : std::nullopt;
        if (!sweep)
            return std::nullopt;
        return std::tan(*sweep / 4) * (cross(form.axis1, form.axis2) > 0 ? 1 : -1);
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::optional<double> bulge;
        if (!path.segments[i].curved)
            bulge = 0;
        for (const std::size_t of : {i, i - 1, i + 1}) // i - 1: beyond all, for the first one
            if (!bulge)
                bulge = bulgeOn(i, of);
        bulges.push_back(bulge);
    }
    return bulges;
}

} // namespace app::dxf::writing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app::svg {
namespace {

using std::numbers::pi;

// The ellipse as an image of the unit circle, and the drawn part of the circle.
struct Ellipse {
    Point centre, axis1, axis2;
    double angle, sweep;

    Point at(double t) const { return centre + axis1 * std::cos(t) + axis2 * std::sin(t); }
    Point slope(double t) const { return axis2 * std::cos(t) - axis1 * std::sin(t); }
};

double angleOf(const Point& p) { return std::atan2(p.y, p.x); }

// SVG 1.1, F.6.5 and F.6.6: conversion from end points to the centre; radii that are too small are
// enlarged.
Ellipse ellipseOf(const Arc& arc)
{
    const double turn = std::remainder(arc.rotation, 360.0) * pi / 180;
    const double c = std::cos(turn), s = std::sin(turn);
    const Point half = arc.from * 0.5 - arc.to * 0.5;
    double rx = std::abs(arc.radii.x), ry = std::abs(arc.radii.y);
    // On the unit circle the ends are at `half` and -`half`, relative to their midpoint.
    Point chord{(c * half.x + s * half.y) / rx, (c * half.y - s * half.x) / ry};
    const double length = std::hypot(chord.x, chord.y);
    if (length > 1) {
        rx *= length;
        ry *= length;
        chord /= length;
    }
    const double free = std::sqrt(std::max(0.0, 1 / std::max(length * length, 1e-300) - 1));
    const double side = length >= 1 ? 0 : arc.large == arc.positive ? -free : free;
    const Point centre{side * chord.y, -side * chord.x};
    const double begin = angleOf(chord - centre);
    double sweep = angleOf(-chord - centre) - begin;
    if (arc.positive && sweep < 0)
        sweep += 2 * pi;
    if (!arc.positive && sweep > 0)
        sweep -= 2 * pi;
    const Point axis1 = Point{c, s} * rx, axis2 = Point{-s, c} * ry;
    const Point middle = arc.from * 0.5 + arc.to * 0.5;
    return {middle + axis1 * centre.x + axis2 * centre.y, axis1, axis2, begin, sweep};
}

bool finite(const Ellipse& e)
{
    return std::isfinite(e.centre.x + e.centre.y + e.axis1.x + e.axis1.y + e.axis2.x + e.axis2.y)
           && std::isfinite(e.angle + e.sweep);
}

} // namespace

void appendArc(std::vector<PathSegment>& segments, const Arc& arc)
{
    if (arc.from == arc.to)
        return;
    const bool flat = arc.radii.x == 0 || arc.radii.y == 0;
    const Ellipse ellipse = flat ? Ellipse{} : ellipseOf(arc);
    if (flat || !finite(ellipse)) {
        segments.push_back({arc.to});
        return;
    }
    const int count = std::max(1, int(std::ceil(std::abs(ellipse.sweep) / (pi / 2) - 1e-9)));
    const double step = ellipse.sweep / count;
    const double reach = 4.0 / 3 * std::tan(step / 4); // of control points along the tangent
    Point last = arc.from;
    for (int i = 0; i < count; ++i) {
        const double t0 = ellipse.angle + i * step, t1 = t0 + step;
        const Point to = i + 1 == count ? arc.to : ellipse.at(t1);
        segments.push_back(
            {to, last + reach * ellipse.slope(t0), to - reach * ellipse.slope(t1), true});
        last = to;
    }
}

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/arc.h"

#include "app/document/arc_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app::svg {
namespace {

using std::numbers::pi;

double angleOf(const Point& p) { return std::atan2(p.y, p.x); }

// SVG 1.1, F.6.5 and F.6.6: conversion from end points to the centre; radii that are too small are
// enlarged.
EllipseArc ellipseOf(const Arc& arc)
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

bool isFiniteArc(const EllipseArc& e)
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
    const EllipseArc ellipse = flat ? EllipseArc{} : ellipseOf(arc);
    if (flat || !isFiniteArc(ellipse)) {
        segments.push_back({arc.to});
        return;
    }
    appendCurves(segments, ellipse, arc.from, arc.to);
}

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/offset_curve.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

constexpr int samples = 8; // of a curve

Point bendOf(const Bezier& curve, double t) // the second derivative
{
    return 6.0
           * ((1 - t) * (curve.control2 - 2.0 * curve.control1 + curve.from)
              + t * (curve.to - 2.0 * curve.control2 + curve.control1));
}

/// How fast the offset curve runs, where the curve runs at speed 1; negative: backwards. Empty
/// where the curve stands still.
std::optional<double> speedAt(const Bezier& curve, double t, double distance)
{
    const Point slope = curve.slope(t);
    const double speed = glm::length(slope);
    if (!(speed > 0))
        return std::nullopt;
    const double curvature = cross(slope, bendOf(curve, t)) / (speed * speed * speed);
    return 1 - curvature * distance;
}

struct Middle {
    Point at, normal;
};

/// The place beside the middle of the curve.
Middle middleOf(const DirectedCurve& of, double distance)
{
    const Point slope = of.curve.slope(0.5);
    const double speed = glm::length(slope);
    const Point normal = speed > 0 ? normalOf(slope / speed) : Point(0);
    return {of.curve.at(0.5) + normal * distance, normal};
}

/// The curve between two points with these handles, made longer or shorter so that it passes its
/// middle.
Bezier throughMiddle(const Point& from, const Point& to, Point handle0, Point handle1,
                     const Middle& middle)
{
    const double away = glm::dot(middle.at - (from + to) / 2.0, middle.normal);
    const double bulge = 3.0 / 8 * glm::dot(handle0 - handle1, middle.normal);
    if (const double scale = away / bulge; scale > 0.5 && scale < 2) {
        handle0 *= scale;
        handle1 *= scale;
    }
    return {from, from + handle0, to - handle1, to};
}

} // namespace

std::optional<OffsetCurve> offsetCurve(const DirectedCurve& of, double distance, double tolerance)
{
    constexpr double leastCosine = -1e-3; // of a quarter turn, and rounding
    const Bezier& curve = of.curve;
    const Point from = curve.from + normalOf(of.direction0) * distance,
                to = curve.to + normalOf(of.direction1) * distance;
    // Where the curve stands still at an end, as many programs draw it, the chords tell the speed.
    const double usual =
        glm::dot(to - from, of.direction0 + of.direction1)
        / std::max(glm::dot(curve.to - curve.from, of.direction0 + of.direction1), 1e-300);
    std::array<double, samples + 1> speeds{};
    for (int i = 0; i <= samples; ++i)
        speeds[std::size_t(i)] = speedAt(curve, double(i) / samples, distance).value_or(usual);
    const bool isReversed = speeds[0] < 0;
    if (std::ranges::any_of(speeds, [&](double s) { return isReversed ? !(s < 0) : !(s > 0); }))
        return std::nullopt;
    if (glm::dot(of.direction0, of.direction1) < leastCosine)
        return std::nullopt;
    const Bezier made = throughMiddle(
        from, to, of.direction0 * (glm::length(curve.slope(0)) * speeds.front() / 3),
        of.direction1 * (glm::length(curve.slope(1)) * speeds.back() / 3), middleOf(of, distance));
    for (int i = 1; i < samples; ++i) {
        const double t = double(i) / samples;
        const Point slope = curve.slope(t);
        const double speed = glm::length(slope);
        if (!(speed > 0) || glm::dot(slope, of.direction0) < leastCosine * speed)
            return std::nullopt;
        const Point normal = normalOf(slope / speed);
        const Point off = made.at(t) - (curve.at(t) + normal * distance);
        // Along the curve it may be ahead or behind.
        if (std::abs(glm::dot(off, normal)) > tolerance
            || glm::length(off) > 0.1 * glm::length(to - from) + tolerance)
            return std::nullopt;
    }
    return OffsetCurve{made, isReversed};
}

} // namespace app

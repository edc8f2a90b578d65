// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/whole_curve.h"

#include "app/cut/true_curve.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace app {
namespace {

constexpr double rounding = 1e-5; // of the curve's size: what files leave of coordinates
constexpr std::size_t mostParts = 16;

/// The number of the next curve; of a closed path the last one is before the first one.
std::optional<std::size_t> nextCurve(const Subpath& path, std::size_t segment)
{
    const bool isLast = segment + 1 == path.segments.size();
    if (isLast && (!path.closed || path.segments.back().to != path.start))
        return std::nullopt;
    const std::size_t next = isLast ? 0 : segment + 1;
    return next != segment && isCurve(path, next) ? std::optional(next) : std::nullopt;
}

std::optional<std::size_t> previousCurve(const Subpath& path, std::size_t segment)
{
    const std::size_t previous = segment > 0 ? segment - 1 : path.segments.size() - 1;
    return isCurve(path, previous) && nextCurve(path, previous) == segment ? std::optional(previous)
                                                                           : std::nullopt;
}

bool isCircle(const EllipseArc& ellipse)
{
    const double a = glm::length(ellipse.axis1), b = glm::length(ellipse.axis2);
    return std::abs(a - b) <= rounding * a
           && std::abs(glm::dot(ellipse.axis1, ellipse.axis2)) <= rounding * a * b;
}

/// Between the axes, as corners of rounded rectangles are.
bool isQuarter(const EllipseArc& ellipse)
{
    constexpr double most = 0.01; // what programs make of 4/3 tan(π / 8)
    const Point begin = ellipse.slope(ellipse.angle),
                end = ellipse.slope(ellipse.angle + ellipse.sweep);
    return std::abs(std::abs(ellipse.sweep) - std::numbers::pi / 2) <= most
           && std::abs(glm::dot(begin, end)) <= most * glm::length(begin) * glm::length(end);
}

bool isOn(const EllipseArc& ellipse, const Bezier& curve)
{
    constexpr double strays = 5e-4; // of the radius
    return std::ranges::all_of(std::array{0.0, 0.3, 0.5, 0.8, 1.0}, [&](double t) {
        const Point p = curve.at(t), there = onEllipse(ellipse, p);
        return glm::distance(there, p) <= strays * glm::distance(there, ellipse.centre);
    });
}

/// For a part that was divided off, and rounded so much that the whole is not found: the ellipse of
/// a curve at most two nodes away.
template <class Beside>
std::optional<EllipseArc> ellipseBeside(const Subpath& path, std::size_t segment,
                                        const Beside& besideOf)
{
    const Bezier curve = curveOf(path, segment);
    auto beside = besideOf(path, segment);
    for (int nodes = 0; nodes < 2 && beside && *beside != segment; ++nodes) {
        const auto ellipse = ellipseOf(curveOf(path, *beside));
        if (ellipse && (isCircle(*ellipse) || isQuarter(*ellipse)))
            return isOn(*ellipse, curve) ? ellipse : std::nullopt;
        beside = besideOf(path, *beside);
    }
    return std::nullopt;
}

} // namespace

// De Casteljau's division: at the share s of the parameter, the handles beside the new node have
// the lengths s : 1 - s.
std::optional<Bezier> joined(const Bezier& first, const Bezier& second)
{
    const double size = glm::distance(first.from, second.to);
    const double a = glm::distance(first.control2, first.to);
    const double b = glm::distance(second.from, second.control1);
    const double s = a / (a + b), most = rounding * size;
    if (!(s > 0 && s < 1))
        return std::nullopt;
    const Bezier whole{first.from, first.from + (first.control1 - first.from) / s,
                       second.to + (second.control2 - second.to) / (1 - s), second.to};
    const Bezier low = whole.part(0, s), high = whole.part(s, 1);
    const bool are = glm::distance(low.control2, first.control2) <= most
                     && glm::distance(low.to, first.to) <= most
                     && glm::distance(high.control1, second.control1) <= most;
    return are ? std::optional(whole) : std::nullopt;
}

bool goesOnAfter(const Subpath& path, std::size_t segment)
{
    const auto next = nextCurve(path, segment);
    return next && joined(curveOf(path, segment), curveOf(path, *next));
}

std::optional<DrawnEllipse> ellipseAt(const Subpath& path, std::size_t segment)
{
    Bezier whole = curveOf(path, segment);
    std::size_t first = segment, last = segment;
    for (std::size_t parts = 1; parts < mostParts; ++parts) {
        const auto next = nextCurve(path, last);
        const auto more = next ? joined(whole, curveOf(path, *next)) : std::nullopt;
        if (!more)
            break;
        whole = *more;
        last = *next;
    }
    for (std::size_t parts = 1; parts < mostParts; ++parts) {
        const auto previous = previousCurve(path, first);
        const auto more = previous ? joined(curveOf(path, *previous), whole) : std::nullopt;
        if (!more)
            break;
        whole = *more;
        first = *previous;
    }
    const auto ellipse = ellipseOf(whole);
    if (!ellipse) {
        auto other = ellipseBeside(path, last, nextCurve);
        if (!other)
            other = ellipseBeside(path, first, previousCurve);
        return other ? std::optional(DrawnEllipse{*other, true}) : std::nullopt;
    }
    const auto goesOnAt = [&](std::optional<std::size_t> beside) {
        return beside && isOn(*ellipse, curveOf(path, *beside));
    };
    return DrawnEllipse{*ellipse, isCircle(*ellipse) || isQuarter(*ellipse)
                                      || goesOnAt(nextCurve(path, last))
                                      || goesOnAt(previousCurve(path, first))};
}

} // namespace app

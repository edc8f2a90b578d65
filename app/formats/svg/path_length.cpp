// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/path_length.h"

#include "app/document/bezier.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app::svg {
namespace {

double distance(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

// By the quadrature of Gauss and Legendre with five points.
double estimate(const Bezier& curve)
{
    struct Node {
        double at, weight;
    };
    constexpr std::array nodes{
        Node{0.046910077030668, 0.118463442528095}, Node{0.230765344947158, 0.239314335249683},
        Node{0.5, 0.284444444444444}, Node{0.769234655052842, 0.239314335249683},
        Node{0.953089922969332, 0.118463442528095}};
    double length = 0;
    for (const auto& [t, weight] : nodes) {
        const Point speed = 3.0
                            * ((1 - t) * (1 - t) * (curve.control1 - curve.from)
                               + 2 * t * (1 - t) * (curve.control2 - curve.control1)
                               + t * t * (curve.to - curve.control2));
        length += weight * std::hypot(speed.x, speed.y);
    }
    return length;
}

double lengthOf(const Bezier& curve, double guess, int depth)
{
    constexpr int deepest = 12;
    const Bezier left = curve.part(0, 0.5), right = curve.part(0.5, 1);
    const double first = estimate(left), second = estimate(right);
    if (depth == deepest || std::abs(first + second - guess) <= 1e-10 * guess)
        return first + second;
    return lengthOf(left, first, depth + 1) + lengthOf(right, second, depth + 1);
}

} // namespace

double lengthOf(std::span<const Subpath> paths)
{
    double length = 0;
    for (const Subpath& path : paths) {
        Point from = path.start;
        for (const PathSegment& segment : path.segments) {
            const Bezier curve{from, segment.control1, segment.control2, segment.to};
            length +=
                segment.curved ? lengthOf(curve, estimate(curve), 0) : distance(from, segment.to);
            from = segment.to;
        }
        if (path.closed)
            length += distance(from, path.start);
    }
    return length;
}

} // namespace app::svg

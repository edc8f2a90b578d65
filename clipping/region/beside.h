// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/exact/turn.h"

// On which side of an edge points lie that are moved by infinitely little, so that none is on an
// edge and no vertex is level with it. Winding numbers are counted along paths between such points;
// vertices on the path and edges along it then need no rules of their own.

namespace clipping {

inline int signOf(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
/// The sign of to - from, also where the difference overflows.
inline int signOf(double from, double to) { return to > from ? 1 : to < from ? -1 : 0; }

/// A directed line: through `at`, in the direction from `from` to `to` (which differ).
struct DirectedLine {
    glm::dvec2 at, from, to;
    glm::dvec2 along; ///< to - from, rounded

    DirectedLine(const glm::dvec2& through, const glm::dvec2& begin, const glm::dvec2& end)
        : at(through), from(begin), to(end), along(end - begin)
    {
    }
    int signX() const { return signOf(from.x, to.x); }
    int signY() const { return signOf(from.y, to.y); }
    /// The side of the line on which p lies: 1 for left, -1 for right, 0 for on it.
    int side(const glm::dvec2& p) const
    {
        const auto [value, error] = sideAsNumber(p);
        return value > error ? 1 : value < -error ? -1 : turnInIntegers(from, to, at, p);
    }
    /// Whether both ends of an edge are certainly on the same side. Without branches, which would
    /// often be mispredicted.
    bool certainlyMisses(const Segment& edge) const
    {
        const auto [atA, errorOfA] = sideAsNumber(edge.a);
        const auto [atB, errorOfB] = sideAsNumber(edge.b);
        const bool areLeft = (atA > errorOfA) & (atB > errorOfB);
        const bool areRight = (atA < -errorOfA) & (atB < -errorOfB);
        return areLeft | areRight;
    }

private:
    struct SideAsNumber {
        double value, error;
    };
    SideAsNumber sideAsNumber(const glm::dvec2& p) const
    {
        const double left = along.x * (p.y - at.y), right = along.y * (p.x - at.x);
        return {left - right, orderBound * (magnitude(left) + magnitude(right)) + tiny};
    }
};

/// The point (x, y) moved to the left by η and down by η², with η infinitely small.
struct Reference {
    glm::dvec2 at;

    bool isRight(const glm::dvec2& p) const { return p.x >= at.x; }
    /// The side of the edge on which this point lies: 1 or -1.
    int side(const Segment& edge) const
    {
        if (const int sign = leftOf(edge.a, edge.b, at).sign)
            return sign;
        const int up = signOf(edge.a.y, edge.b.y);
        return up != 0 ? up : -signOf(edge.a.x, edge.b.x);
    }
};

/// The start of a line moved forwards along it by ε, and sideways by δ, with δ much smaller than ε:
/// to the left if `left` is 1, to the right if it is -1.
struct BesideStart {
    const DirectedLine& line;
    int left;

    bool isAbove(const glm::dvec2& p) const
    {
        if (p.y != line.at.y)
            return p.y > line.at.y;
        const int up = line.signY(); // the sign of this point's y
        return (up != 0 ? up : left * line.signX()) < 0;
    }
    int side(const Segment& edge) const
    {
        if (const int sign = leftOf(edge.a, edge.b, line.at).sign)
            return sign;
        const glm::dvec2 along{edge.b.x - edge.a.x, edge.b.y - edge.a.y};
        if (const int sign = cross(along, edge.a, edge.b, line.from, line.to).sign)
            return sign;
        // The edge lies on the line, in the same or in the opposite direction.
        const int x = line.signX() * signOf(edge.a.x, edge.b.x);
        return left * (x != 0 ? x : line.signY() * signOf(edge.a.y, edge.b.y));
    }
};

/// The corner of the path from a reference point, upwards or downwards, then sideways to a point
/// beside a start: its x is that of the reference, its y that of the other. η is much smaller than
/// δ.
struct PathCorner {
    const Reference& reference;
    const BesideStart& start;

    int side(const Segment& edge) const
    {
        const DirectedLine& line = start.line;
        if (const int sign = leftOf(edge.a, edge.b, {reference.at.x, line.at.y}).sign)
            return sign;
        if (const int right = signOf(edge.a.x, edge.b.x); right != 0)
            return right * (line.signY() != 0 ? line.signY() : start.left * line.signX());
        return signOf(edge.a.y, edge.b.y);
    }
};

/// The straight path from a reference to a point beside a start.
struct StraightPath {
    const Reference& from;
    const BesideStart& to;

    /// The side of the path's line on which p lies: 1 or -1.
    int side(const glm::dvec2& p) const
    {
        const DirectedLine& line = to.line;
        if (p == from.at)
            return to.isAbove(p) ? 1 : -1;
        if (const int sign = leftOf(from.at, line.at, p).sign)
            return sign;
        // The start is moved along its line by ε.
        if (const int sign = cross(line.along, line.from, line.to, from.at, p).sign)
            return sign;
        // And sideways by δ; p is ahead of the reference or behind it.
        const int ahead = line.signX() != 0 ? line.signX() * signOf(from.at.x, p.x)
                                            : line.signY() * signOf(from.at.y, p.y);
        return -to.left * ahead;
    }
};

/// The straight path from a reference to another one, at another place.
struct PathBetween {
    const Reference &from, &to;

    /// The side of the path's line on which p lies: 1 or -1.
    int side(const glm::dvec2& p) const
    {
        if (const int sign = leftOf(from.at, to.at, p).sign)
            return sign;
        const int up = signOf(from.at.y, to.at.y);
        return up != 0 ? -up : signOf(from.at.x, to.at.x);
    }
};

/// How much the winding number grows along a path, on account of one edge. Crossing an edge from
/// its right to its left adds 1.
template <class Straight>
int windingStep(const Segment& edge, const Straight& path)
{
    if (path.side(edge.a) == path.side(edge.b))
        return 0;
    return (path.to.side(edge) - path.from.side(edge)) / 2;
}

/// From the reference to its corner, and on to the point beside the start.
struct CornerPath {
    const Reference& reference;
    const BesideStart& start;
};

inline int windingStep(const Segment& edge, const CornerPath& path)
{
    const auto& [reference, start] = path;
    const bool upwards = reference.isRight(edge.a) != reference.isRight(edge.b);
    const bool sideways = start.isAbove(edge.a) != start.isAbove(edge.b);
    if (!upwards && !sideways)
        return 0;
    const int corner = PathCorner{reference, start}.side(edge);
    const int first = upwards ? corner - reference.side(edge) : 0;
    const int second = sideways ? start.side(edge) - corner : 0;
    return (first + second) / 2;
}

} // namespace clipping

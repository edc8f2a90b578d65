// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/arc_curves.h"
#include "app/document/bezier.h"
#include "app/document/flatten.h"
#include "app/document/subpath.h"

#include <optional>

namespace app {

/// A curve of a border: a Bézier curve with its parameters from 0 to 1, or an ellipse with angles
/// in radians, of any number of turns.
struct BorderCurve {
    std::optional<Bezier> bezier{};
    EllipseArc ellipse{}; ///< without `bezier`; its own angle and sweep do not count

    Point at(double t) const;
    Point slope(double t) const;
    /// The parameter of the place that is nearest to a point; of an ellipse, less than half a turn
    /// from another parameter.
    double near(const Point& p, double other) const;
    /// Appends the part between two parameters, in either direction, as curves that begin and end
    /// at these points.
    void append(std::vector<PathSegment>& segments, double from, double to, const Point& start,
                const Point& end) const;
};

/// A part of a curve, from one parameter to another, in either direction.
struct BorderPart {
    const BorderCurve* curve;
    double from, to;

    double parameterAt(double share) const
    {
        return share == 0 ? from : share == 1 ? to : from + (to - from) * share;
    }
};

bool isCurve(const Subpath& path, std::size_t segment); ///< false behind its last segment
Bezier curveOf(const Subpath& path, std::size_t segment);

/// A place on a curve.
struct CurvePoint {
    double t;
    Point point;
};

/// Where a curve passes from one side to the other within the chord's part of it: the last
/// parameter on the side of `chord.t0`, by bisection. Empty if both ends are on one side: the chord
/// then cuts a corner that the curve misses.
template <class IsBeyond>
std::optional<double> passage(const Bezier& curve, const Chord& chord, const IsBeyond& isBeyond)
{
    double low = chord.t0, high = chord.t1;
    const bool atLow = isBeyond(curve.at(low));
    if (atLow == isBeyond(curve.at(high)))
        return std::nullopt;
    for (double middle = (low + high) / 2; middle > low && middle < high; middle = (low + high) / 2)
        (isBeyond(curve.at(middle)) == atLow ? low : high) = middle;
    return low;
}

/// The passage through the line of a window's edge. On a horizontal or vertical edge the point has
/// the edge's coordinate.
std::optional<CurvePoint> crossing(const Bezier& curve, const Chord& chord,
                                   const clipping::Segment& edge);

} // namespace app

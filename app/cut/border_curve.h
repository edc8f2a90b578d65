// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/arc_curves.h"
#include "app/document/bezier.h"

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

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/whole_curve.h"
#include "app/document/arc_curves.h"
#include "app/document/bezier.h"
#include "app/document/flatten.h"
#include "app/document/subpath.h"

#include <array>
#include <optional>
#include <utility>

namespace app {

bool isCurve(const Subpath& path, std::size_t segment); ///< false behind its last segment
Bezier curveOf(const Subpath& path, std::size_t segment);

/// A place on a curve.
struct CurvePoint {
    double t;
    Point point;
};

/// A curve of a path as it counts where it is cut: a Bézier curve, or the part of an ellipse that
/// is drawn by one, or by one that was divided. Its parameters go from 0 to 1.
class TrueCurve {
public:
    /// The segment is a curve. If it is not certainly drawn for an ellipse, the ellipse counts if
    /// it is known: isKnown(EllipseArc).
    template <class IsKnown>
    TrueCurve(const Subpath& path, std::size_t segment, const IsKnown& isKnown)
        : TrueCurve(curveOf(path, segment))
    {
        const auto drawn = ellipseAt(path, segment);
        if (drawn && (drawn->isCertain || isKnown(drawn->ellipse)))
            countAs(drawn->ellipse);
    }

    const std::optional<EllipseArc>& ellipse() const { return ellipse_; }

    Point at(double t) const;
    Point slope(double t) const; ///< the derivative
    /// The parameter of the place that is nearest to a point; of an ellipse, if the point is near.
    double near(const Point& p) const;
    /// The same of the part [low, high], which hardly bends, from a guess on.
    double near(const Point& p, double low, double high, double guess) const;
    double near(const Point& p, double low, double high) const
    {
        return near(p, low, high, low + (high - low) / 2);
    }
    struct Places {
        std::array<double, 2> t;
        int count = 0;
        const double* begin() const { return t.data(); }
        const double* end() const { return t.data() + count; }
        void add(double place)
        {
            if (place > 0 && place < 1 && count < 2)
                t[std::size_t(count++)] = place;
        }
    };
    /// Where the curve has a direction, in either sense, between its ends.
    Places parallelTo(const Point& direction) const;
    clipping::Window box() const; ///< around the curve, not the smallest one
    /// The curve's chord ends, the first one at 0, each chord within a tolerance of its part.
    std::vector<CurvePoint> points(double tolerance) const;
    /// Appends the part between two parameters, in either direction, which begins and ends at these
    /// points. All of it is the curve as it is drawn.
    void append(std::vector<PathSegment>& segments, double from, double to, const Point& start,
                const Point& end) const;

    friend bool operator==(const TrueCurve&, const TrueCurve&) = default;

private:
    explicit TrueCurve(const Bezier& drawn) : drawn_(drawn), begin_(drawn.from), end_(drawn.to) {}
    void countAs(const EllipseArc& ellipse);
    std::pair<Point, Point> placeAt(double t) const; ///< the point and the slope
    double angleAt(double t) const { return ellipse_->angle + ellipse_->sweep * t; }

    Bezier drawn_;
    std::optional<EllipseArc> ellipse_; ///< from the curve's begin to its end
    Point begin_, end_;
};

/// A part of a curve, from one parameter to another, in either direction.
struct CurvePart {
    const TrueCurve* curve;
    double from, to;

    double parameterAt(double share) const
    {
        return share == 0 ? from : share == 1 ? to : from + (to - from) * share;
    }
};

/// Parameters of two curves.
struct CurvePlaces {
    double t, u;
};

/// Where the curve of a chord meets a part of another one, by Newton's steps from a guess. It may
/// be on a neighbouring part of the same curves.
std::optional<CurvePlaces> meetingNear(const TrueCurve& curve, const Chord& chord,
                                       const CurvePart& part, CurvePlaces at);

/// Where a curve passes from one side to the other within the chord's part of it: the last
/// parameter on the side of `chord.t0`, by bisection. Empty if both ends are on one side: the chord
/// then cuts a corner that the curve misses.
template <class IsBeyond>
std::optional<double> passage(const TrueCurve& curve, const Chord& chord, const IsBeyond& isBeyond)
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
std::optional<CurvePoint> crossing(const TrueCurve& curve, const Chord& chord,
                                   const clipping::Segment& edge);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/curve_at_edge.h"
#include "app/cut/curved_border.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

// The polygon only tells which edge is met: a cut lies where the true curves meet.

namespace app {
namespace {

double cross(const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; }

/// The part of a curve that an edge stands for, from 0 at its start to 1 at its end.
class TrueEdge {
public:
    TrueEdge(const Bezier& curve, double t0, double t1) : curve_(curve), t0_(t0), t1_(t1) {}
    /// The part of an ellipse from one of its points to another, less than half a turn.
    TrueEdge(const EllipseArc& ellipse, const Point& from, const Point& to) : ellipse_(ellipse)
    {
        const auto angleOf = [&](const Point& p) {
            const Point way = p - ellipse.centre;
            const double all = cross(ellipse.axis1, ellipse.axis2);
            return std::atan2(cross(ellipse.axis1, way) / all, cross(way, ellipse.axis2) / all);
        };
        t0_ = angleOf(from);
        t1_ = t0_ + std::remainder(angleOf(to) - t0_, 2 * M_PI);
    }

    Point at(double share) const
    {
        const double t = t0_ + (t1_ - t0_) * share;
        return curve_ ? curve_->at(t) : ellipse_.at(t);
    }
    Point slope(double share) const
    {
        const double t = t0_ + (t1_ - t0_) * share;
        return (t1_ - t0_) * (curve_ ? curve_->slope(t) : ellipse_.slope(t));
    }

private:
    std::optional<Bezier> curve_;
    EllipseArc ellipse_{};
    double t0_, t1_;
};

template <class Edge>
TrueEdge trueEdge(const Edge& edge, const Point& end, std::span<const Bezier> sources)
{
    if (edge.source < sources.size())
        return {sources[edge.source], edge.t0, edge.t1};
    return {*edge.ellipse, edge.from, end};
}

} // namespace

std::optional<CurvedBorder::Place> CurvedBorder::edgeThrough(const Point& cut) const
{
    std::optional<Place> nearest;
    double least = near_ / 1000; // a nanometre on paper
    index_.meeting({cut, cut}, 0, [&](std::uint32_t number) {
        const Place& place = edges_[number];
        const double distance = placeOn(edgeAt(place).from, endOf(place), cut).distance;
        if (distance <= least) {
            least = distance;
            nearest = place;
        }
    });
    return nearest;
}

std::optional<Point> CurvedBorder::meeting(const clipping::Segment& line, const Point& cut) const
{
    const auto place = edgeThrough(cut);
    if (!place)
        return std::nullopt;
    const auto isLeft = [&](const Point& p) { return cross(line.b - line.a, p - line.a) > 0; };
    const TrueEdge edge = trueEdge(edgeAt(*place), endOf(*place), sources_);
    double low = 0, high = 1;
    const bool atLow = isLeft(edge.at(low));
    if (atLow == isLeft(edge.at(high)))
        return std::nullopt;
    for (double middle = 0.5; middle > low && middle < high; middle = (low + high) / 2)
        (isLeft(edge.at(middle)) == atLow ? low : high) = middle;
    const Point met = edge.at(low);
    const bool isBeyond =
        glm::dot(met - line.a, line.b - line.a) < 0 || glm::dot(met - line.b, line.a - line.b) < 0;
    return isBeyond ? std::nullopt : std::optional(met);
}

std::optional<CurvePoint> CurvedBorder::meeting(const Bezier& curve, const Chord& chord,
                                                const Point& cut) const
{
    const auto place = edgeThrough(cut);
    if (!place)
        return std::nullopt;
    const TrueEdge edge = trueEdge(edgeAt(*place), endOf(*place), sources_);
    const double width = chord.t1 - chord.t0;
    double t = chord.t0 + width * placeOn(chord.segment.a, chord.segment.b, cut).parts;
    double share = placeOn(edgeAt(*place).from, endOf(*place), cut).parts;
    constexpr int most = 20;
    for (int i = 0; i < most; ++i) {
        const Point gap = edge.at(share) - curve.at(t);
        const Point along = curve.slope(t), across = edge.slope(share);
        const double turn = cross(along, across);
        const double byT = cross(gap, across) / turn, byShare = cross(gap, along) / turn;
        if (!std::isfinite(byT) || !std::isfinite(byShare))
            return std::nullopt;
        t += byT;
        share += byShare;
        // It may be on a neighbouring part of the same curves.
        if (t < std::max(0.0, chord.t0 - width) || t > std::min(1.0, chord.t1 + width) || share < -1
            || share > 2)
            return std::nullopt;
        if (std::abs(byT) <= 1e-15 && std::abs(byShare) <= 1e-12)
            break;
    }
    const Point met = curve.at(t);
    return glm::distance(met, edge.at(share)) <= near_ / 1e4 ? std::optional(CurvePoint{t, met})
                                                             : std::nullopt;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/true_curve.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

constexpr int mostChords = 10'000; // of a quarter turn

/// How far a point is from an ellipse that it is on, in sizes of its curve: where programs round.
constexpr double onIt = 1e-9;

/// The larger half axis, from two conjugate ones.
double longAxisOf(const EllipseArc& ellipse)
{
    const double a = glm::dot(ellipse.axis1, ellipse.axis1),
                 b = glm::dot(ellipse.axis2, ellipse.axis2),
                 c = glm::dot(ellipse.axis1, ellipse.axis2);
    return std::sqrt((a + b + std::hypot(a - b, 2 * c)) / 2);
}

bool isLeftOf(const clipping::Segment& line, const Point& p)
{
    return cross(line.b - line.a, p - line.a) > 0;
}

} // namespace

void TrueCurve::countAs(const EllipseArc& ellipse)
{
    ellipse_ = ellipse;
    ellipse_->angle = angleTowards(ellipse, begin_);
    ellipse_->sweep =
        std::remainder(angleTowards(ellipse, end_) - ellipse_->angle, 2 * std::numbers::pi);
    const double most = onIt * glm::distance(begin_, end_);
    for (Point* p : {&begin_, &end_})
        if (const Point on = onEllipse(ellipse, *p); glm::distance(on, *p) > most)
            *p = on; // where a curve was divided
}

Point TrueCurve::at(double t) const
{
    return !ellipse_ ? drawn_.at(t) : t == 0 ? begin_ : t == 1 ? end_ : ellipse_->at(angleAt(t));
}

Point TrueCurve::slope(double t) const
{
    return ellipse_ ? ellipse_->sweep * ellipse_->slope(angleAt(t)) : drawn_.slope(t);
}

// Both for one sine and cosine.
std::pair<Point, Point> TrueCurve::placeAt(double t) const
{
    if (!ellipse_)
        return {drawn_.at(t), drawn_.slope(t)};
    const auto& [centre, axis1, axis2, angle, sweep] = *ellipse_;
    const double c = std::cos(angleAt(t)), s = std::sin(angleAt(t));
    return {centre + axis1 * c + axis2 * s, sweep * (axis2 * c - axis1 * s)};
}

double TrueCurve::near(const Point& p) const
{
    if (!ellipse_)
        return nearestParameter(drawn_, p);
    const double middle = angleAt(0.5);
    const double way = std::remainder(angleTowards(*ellipse_, p) - middle, 2 * std::numbers::pi);
    const double t = 0.5 + way / ellipse_->sweep;
    constexpr double little = 0.01;
    return near(p, std::clamp(t - little, 0.0, 1.0), std::clamp(t + little, 0.0, 1.0));
}

double TrueCurve::near(const Point& p, double low, double high, double guess) const
{
    double t = guess;
    constexpr int most = 12;
    constexpr double little = 1e-15;
    for (int i = 0; i < most; ++i) {
        const auto [on, along] = placeAt(t);
        const double length = glm::dot(along, along);
        if (!(length > 0))
            break;
        const double last = t;
        t = std::clamp(t + glm::dot(p - on, along) / length, low, high);
        if (std::abs(t - last) <= little)
            break;
    }
    return t;
}

TrueCurve::Places TrueCurve::parallelTo(const Point& direction) const
{
    Places places;
    if (ellipse_) {
        const double angle =
            std::atan2(cross(direction, ellipse_->axis2), cross(direction, ellipse_->axis1));
        for (const double each : {angle, angle + std::numbers::pi})
            places.add(
                0.5 + std::remainder(each - angleAt(0.5), 2 * std::numbers::pi) / ellipse_->sweep);
        return places;
    }
    const double first = cross(direction, drawn_.control1 - drawn_.from),
                 second = cross(direction, drawn_.control2 - drawn_.control1),
                 third = cross(direction, drawn_.to - drawn_.control2);
    const double a = first - 2 * second + third, b = second - first;
    const double root = b * b - a * first;
    if (root < 0)
        return places;
    const double q = -(b + std::copysign(std::sqrt(root), b)); // no difference of equal numbers
    if (a != 0)
        places.add(q / a);
    if (q != 0)
        places.add(first / q);
    return places;
}

clipping::Window TrueCurve::box() const
{
    if (ellipse_) {
        const auto& [centre, a, b, angle, sweep] = *ellipse_;
        const Point reach(std::hypot(a.x, b.x), std::hypot(a.y, b.y));
        clipping::Window all{centre - reach, centre + reach};
        const Point stray = Point(glm::distance(drawn_.from, drawn_.control1)
                                  + glm::distance(drawn_.control1, drawn_.control2)
                                  + glm::distance(drawn_.control2, drawn_.to));
        return {glm::max(all.min, glm::min(begin_, end_) - stray),
                glm::min(all.max, glm::max(begin_, end_) + stray)};
    }
    return {glm::min(glm::min(drawn_.from, drawn_.control1), glm::min(drawn_.control2, drawn_.to)),
            glm::max(glm::max(drawn_.from, drawn_.control1), glm::max(drawn_.control2, drawn_.to))};
}

std::vector<CurvePoint> TrueCurve::points(double tolerance) const
{
    std::vector<CurvePoint> points{{0, begin_}};
    if (!ellipse_) {
        std::vector<Chord> chords;
        flatten(drawn_.from, {drawn_.to, drawn_.control1, drawn_.control2, true}, 0, tolerance,
                chords);
        for (const Chord& chord : chords)
            points.push_back({chord.t1, chord.segment.b});
        return points;
    }
    const double radius = longAxisOf(*ellipse_);
    const double step = 2 * std::acos(1 - std::min(tolerance / radius, 1.0));
    const double count = std::ceil(std::abs(ellipse_->sweep) / step);
    const int n = count > 1 ? int(std::min<double>(count, mostChords)) : 1;
    for (int k = 1; k <= n; ++k)
        points.push_back({double(k) / n, at(double(k) / n)});
    return points;
}

void TrueCurve::append(std::vector<PathSegment>& segments, double from, double to,
                       const Point& start, const Point& end) const
{
    if (from == 0 && to == 1 && start == drawn_.from && end == drawn_.to)
        return segments.push_back({drawn_.to, drawn_.control1, drawn_.control2, true});
    if (ellipse_) {
        const auto& [centre, axis1, axis2, angle, sweep] = *ellipse_;
        return appendCurves(segments, {centre, axis1, axis2, angleAt(from), sweep * (to - from)},
                            start, end);
    }
    const Bezier part = drawn_.part(std::min(from, to), std::max(from, to));
    segments.push_back(from < to ? PathSegment{end, part.control1, part.control2, true}
                                 : PathSegment{end, part.control2, part.control1, true});
}

std::optional<CurvePlaces> meetingNear(const TrueCurve& curve, const Chord& chord,
                                       const CurvePart& part, CurvePlaces at)
{
    const double width = chord.t1 - chord.t0, reach = part.to - part.from;
    constexpr int most = 20;
    constexpr double little = 1e-15;
    for (int i = 0; i < most; ++i) {
        const Point gap = part.curve->at(at.u) - curve.at(at.t);
        const Point along = curve.slope(at.t), across = part.curve->slope(at.u);
        const double turn = cross(along, across);
        const double byT = cross(gap, across) / turn, byU = cross(gap, along) / turn;
        if (!std::isfinite(byT) || !std::isfinite(byU))
            return std::nullopt;
        at.t += byT;
        at.u += byU;
        if (at.t < std::max(0.0, chord.t0 - width) || at.t > std::min(1.0, chord.t1 + width)
            || std::abs(at.u - part.from - reach / 2) > 1.5 * std::abs(reach))
            return std::nullopt;
        if (std::abs(byT) <= little && std::abs(byU) <= little)
            break;
    }
    return at;
}

bool isCurve(const Subpath& path, std::size_t segment)
{
    return segment < path.segments.size() && path.segments[segment].curved;
}

Bezier curveOf(const Subpath& path, std::size_t segment)
{
    const PathSegment& s = path.segments[segment];
    return {segment == 0 ? path.start : path.segments[segment - 1].to, s.control1, s.control2,
            s.to};
}

std::optional<CurvePoint> crossing(const TrueCurve& curve, const Chord& chord,
                                   const clipping::Segment& edge)
{
    const auto t = passage(curve, chord, [&](const Point& p) { return isLeftOf(edge, p); });
    if (!t)
        return std::nullopt;
    CurvePoint found{*t, curve.at(*t)};
    for (const int axis : {0, 1})
        if (edge.a[axis] == edge.b[axis])
            found.point[axis] = edge.a[axis];
    return found;
}

} // namespace app

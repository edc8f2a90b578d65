// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/spline.h"

#include "app/document/bezier.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace app::dxf {
namespace {

/// A point of the curve and the derivative there.
struct OnCurve {
    Point at, slope;
};

class Evaluator {
public:
    explicit Evaluator(const Spline& spline) : spline_(spline) {}

    /// At u, in the knot span [knots[span], knots[span + 1]]; de Boor's algorithm.
    OnCurve at(double u, std::size_t span)
    {
        const std::size_t degree = spline_.degree;
        const auto& knots = spline_.knots;
        const auto first = spline_.points.begin() + std::ptrdiff_t(span - degree);
        work_.assign(first, first + std::ptrdiff_t(degree) + 1);
        glm::dvec3 slope{0};
        for (std::size_t level = 1; level <= degree; ++level) {
            if (level == degree)
                slope = (work_[degree] - work_[degree - 1])
                        * (double(degree) / (knots[span + 1] - knots[span]));
            for (std::size_t i = degree; i >= level; --i) {
                const double low = knots[span - degree + i], high = knots[span + 1 + i - level];
                const double share = (u - low) / (high - low);
                work_[i] = work_[i - 1] * (1 - share) + work_[i] * share;
            }
        }
        const glm::dvec3& p = work_[degree];
        const Point at(p.x / p.z, p.y / p.z);
        return {at, (Point(slope) - at * slope.z) / p.z};
    }

private:
    const Spline& spline_;
    std::vector<glm::dvec3> work_;
};

class Fitter {
public:
    Fitter(const Spline& spline, double tolerance) : evaluator_(spline), tolerance_(tolerance) {}

    void add(double from, double to, std::size_t span, Subpath& path, int depth = 0)
    {
        const OnCurve begin = evaluator_.at(from, span), end = evaluator_.at(to, span);
        const double third = (to - from) / 3;
        const Bezier curve{begin.at, begin.at + begin.slope * third, end.at - end.slope * third,
                           end.at};
        const bool may = depth < deepest && path.segments.size() < mostCurves;
        if (may && !isNear(curve, from, to, span)) {
            const double middle = (from + to) / 2;
            add(from, middle, span, path, depth + 1);
            add(middle, to, span, path, depth + 1);
            return;
        }
        if (path.segments.empty())
            path.start = curve.from;
        path.segments.push_back({curve.to, curve.control1, curve.control2, true});
    }

private:
    static constexpr int deepest = 12;
    static constexpr std::size_t mostCurves = 200'000; ///< further spans are one curve each

    bool isNear(const Bezier& curve, double from, double to, std::size_t span)
    {
        constexpr std::array places{0.25, 0.5, 0.75};
        return std::ranges::all_of(places, [&](double t) {
            const Point there = evaluator_.at(from + (to - from) * t, span).at;
            return glm::distance(there, curve.at(t)) <= tolerance_ / 2;
        });
    }

    Evaluator evaluator_;
    double tolerance_;
};

} // namespace

bool Spline::isValid() const
{
    return degree >= 1 && points.size() > degree && knots.size() == points.size() + degree + 1
           && std::ranges::is_sorted(knots)
           && std::ranges::all_of(points, [](const glm::dvec3& p) { return p.z > 0; });
}

Subpath pathOf(const Spline& spline, double tolerance)
{
    Subpath path;
    Fitter fitter(spline, tolerance);
    for (std::size_t span = spline.degree; span < spline.points.size(); ++span)
        if (spline.knots[span] < spline.knots[span + 1])
            fitter.add(spline.knots[span], spline.knots[span + 1], span, path);
    return path;
}

namespace {

// The tangents at inner points make the second derivative continuous: a tridiagonal system. A free
// end has no second derivative; `lengths` are the parameter lengths between points.
struct Tangents {
    std::vector<double> below, middle, above;
    std::vector<Point> right;

    explicit Tangents(std::size_t count)
        : below(count), middle(count, 1), above(count), right(count)
    {
    }
    std::vector<Point> solved()
    {
        for (std::size_t i = 1; i < right.size(); ++i) {
            const double factor = below[i] / middle[i - 1];
            middle[i] -= factor * above[i - 1];
            right[i] -= factor * right[i - 1];
        }
        right.back() /= middle.back();
        for (std::size_t i = right.size() - 1; i-- > 0;)
            right[i] = (right[i] - above[i] * right[i + 1]) / middle[i];
        return std::move(right);
    }
};

} // namespace

Subpath pathThrough(const std::vector<Point>& all, const Point& beginTangent,
                    const Point& endTangent, bool closed)
{
    std::vector<Point> points;
    for (const Point& p : all)
        if (points.empty() || p != points.back())
            points.push_back(p);
    if (closed && points.size() > 2 && points.front() != points.back())
        points.push_back(points.front());
    if (points.size() < 2)
        return {points.empty() ? Point(0) : points.front(), {}, false};
    const std::size_t last = points.size() - 1;
    const auto length = [&](std::size_t i) { return glm::distance(points[i], points[i + 1]); };
    const auto chord = [&](std::size_t i) { return (points[i + 1] - points[i]) / length(i); };
    Tangents tangents(points.size());
    const auto setEnd = [&](std::size_t at, const Point& tangent, const Point& along,
                            double& beside) {
        if (tangent != Point(0)) {
            tangents.right[at] = glm::normalize(tangent);
            return;
        }
        tangents.middle[at] = 2;
        beside = 1;
        tangents.right[at] = 3.0 * along;
    };
    setEnd(0, beginTangent, chord(0), tangents.above[0]);
    setEnd(last, endTangent, chord(last - 1), tangents.below[last]);
    for (std::size_t i = 1; i < last; ++i) {
        const double before = length(i - 1), after = length(i);
        tangents.below[i] = after;
        tangents.middle[i] = 2 * (before + after);
        tangents.above[i] = before;
        tangents.right[i] = 3.0 * (chord(i - 1) * after + chord(i) * before);
    }
    const std::vector<Point> slopes = tangents.solved();
    Subpath path{points.front(), {}, closed && last > 1};
    for (std::size_t i = 0; i < last; ++i) {
        const double third = length(i) / 3;
        path.segments.push_back({points[i + 1], points[i] + slopes[i] * third,
                                 points[i + 1] - slopes[i + 1] * third, true});
    }
    return path;
}

} // namespace app::dxf

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/freehand.h"

#include "app/document/flatten.h"
#include "app/nodes/curve_fit.h"
#include "app/view/picking.h"
#include "app/view/simplify.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

// After Philip J. Schneider, "An Algorithm for Automatically Fitting Digitized Curves", Graphics
// Gems, 1990: one curve for as many points as the tolerance allows, otherwise two, which meet
// smoothly where the one was farthest away.

namespace app {
namespace {

// Shares of the tolerance: for leaving out points and for measuring along chords.
constexpr double forPoints = 0.05, forChords = 0.05;
constexpr double around = 3;                     // tolerances: how far a direction is averaged
constexpr double sharp = std::numbers::pi / 3.5; // the least turn of a corner
constexpr double apart = 4;                      // tolerances: between two points on a line
constexpr double mostBetween = 16;               // points on a line
constexpr std::size_t mostPoints = 200;          // that one curve is tried for
constexpr std::size_t places = 4;                // of a piece, where distances are measured

class Fit {
public:
    Fit(std::vector<Point> points, double tolerance)
        : points_(std::move(points)), tolerance_(tolerance)
    {
    }

    Subpath path()
    {
        Subpath path{points_.front(), {}, false};
        std::size_t from = 0;
        for (const std::size_t corner : corners()) {
            run(path, from, corner);
            from = corner;
        }
        run(path, from, points_.size() - 1);
        return path;
    }

private:
    /// The point about `around` tolerances before or after point i (step −1, 1), within the run.
    Point beyond(std::size_t i, int step, std::size_t first, std::size_t last) const
    {
        const Point& at = points_[i];
        while (i != (step < 0 ? first : last)) {
            i += std::size_t(step);
            if (glm::distance(points_[i], at) >= around * tolerance_)
                break;
        }
        return points_[i];
    }
    double turnAt(std::size_t i) const
    {
        const std::size_t last = points_.size() - 1;
        const Point a = points_[i] - beyond(i, -1, 0, last), b = beyond(i, 1, 0, last) - points_[i];
        return std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)));
    }
    /// Of points near each other, the one where the stroke turns most.
    std::vector<std::size_t> corners() const
    {
        std::vector<std::size_t> corners;
        double most = 0; // the turn at the last one
        for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
            const double turn = turnAt(i);
            if (turn < sharp)
                continue;
            const bool near =
                !corners.empty()
                && glm::distance(points_[corners.back()], points_[i]) < 2 * around * tolerance_;
            if (near && turn <= most)
                continue;
            if (near)
                corners.pop_back();
            corners.push_back(i);
            most = turn;
        }
        return corners;
    }
    static Point unit(const Point& p)
    {
        const double length = glm::length(p);
        return length > 0 ? p / length : Point(1, 0);
    }

    /// Part of a run with the directions of the stroke at its ends.
    struct Part {
        std::size_t first, last;
        Point start, end;
    };
    void run(Subpath& path, std::size_t first, std::size_t last) const
    {
        std::vector<Part> parts{{first, last, unit(beyond(first, 1, first, last) - points_[first]),
                                 unit(points_[last] - beyond(last, -1, first, last))}};
        while (!parts.empty()) {
            const Part part = parts.back();
            parts.pop_back();
            const std::size_t split = add(path, part);
            if (split == part.first)
                continue;
            const Point along =
                unit(beyond(split, 1, first, last) - beyond(split, -1, first, last));
            parts.push_back({split, part.last, along, part.end});
            parts.push_back({part.first, split, part.start, along});
        }
    }
    /// Adds the part as one curve; otherwise returns where to split it.
    std::size_t add(Subpath& path, const Part& part) const
    {
        if (part.last - part.first > mostPoints)
            return (part.first + part.last) / 2;
        const Bezier curve = curveOf(part);
        const std::size_t worst = farthest(curve, part);
        if (worst != part.first)
            return worst;
        path.segments.push_back({curve.to, curve.control1, curve.control2, true});
        return part.first;
    }
    Bezier curveOf(const Part& part) const
    {
        std::vector<Bezier> pieces;
        for (std::size_t i = part.first; i < part.last; ++i) {
            const Point &a = points_[i], &b = points_[i + 1];
            pieces.push_back({a, a + (b - a) / 3.0, b - (b - a) / 3.0, b});
        }
        Bezier &first = pieces.front(), &last = pieces.back();
        first.control1 = first.from + part.start * (glm::distance(first.from, first.to) / 3);
        last.control2 = last.to - part.end * (glm::distance(last.from, last.to) / 3);
        return pieces.size() == 1 ? first : fitted(pieces, places);
    }
    /// The inner point that is farthest away from the curve; the first one: none is too far.
    std::size_t farthest(const Bezier& curve, const Part& part) const
    {
        std::vector<Chord> chords;
        flatten(curve.from, {curve.to, curve.control1, curve.control2, true}, 0,
                forChords * tolerance_, chords);
        double most = (1 - forPoints - forChords) * tolerance_;
        std::size_t farthest = part.first;
        for (std::size_t i = part.first + 1; i < part.last; ++i) {
            double nearest = HUGE_VAL;
            for (const Chord& chord : chords)
                nearest = std::min(nearest, distance(points_[i], chord.segment));
            if (nearest > most) {
                most = nearest;
                farthest = i;
            }
        }
        return farthest;
    }

    std::vector<Point> points_;
    double tolerance_;
};

/// With points between those that are far from each other.
std::vector<Point> dense(const std::vector<Point>& points, double most)
{
    std::vector<Point> all{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Point from = points[i - 1], way = points[i] - from;
        const double count = std::min(std::ceil(glm::length(way) / most), mostBetween);
        for (int k = 1; k < int(count); ++k)
            all.push_back(from + way * (k / count));
        all.push_back(points[i]);
    }
    return all;
}

} // namespace

Subpath smoothed(std::span<const Point> stroke, double tolerance)
{
    const auto few = simplified(stroke, forPoints * tolerance);
    if (few.size() == 2)
        return {few[0], {{few[1]}}, false};
    return Fit(dense(few, apart * tolerance), tolerance).path();
}

} // namespace app

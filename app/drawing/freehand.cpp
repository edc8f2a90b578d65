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
constexpr std::size_t atOnce = 500;              // points that are simplified together
constexpr std::size_t waiting = 1500; // the last points of a stroke, whose curves may still change

/// A fitted curve and where it ends.
struct Piece {
    PathSegment segment;
    std::size_t last;        ///< the point at its end
    std::optional<Point> on; ///< the direction in which the next one goes on; empty: at a corner
};

class Fit {
public:
    /// `start` is the direction at the first point; empty: that of the points.
    Fit(std::span<const Point> points, double tolerance, const std::optional<Point>& start)
        : points_(points), tolerance_(tolerance), start_(start)
    {
    }

    std::vector<Piece> pieces()
    {
        std::size_t from = 0;
        for (const std::size_t corner : corners()) {
            run(from, corner);
            from = corner;
        }
        run(from, points_.size() - 1);
        return std::move(pieces_);
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
        return std::abs(std::atan2(cross(a, b), glm::dot(a, b)));
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
    void run(std::size_t first, std::size_t last)
    {
        const Point start = unit(beyond(first, 1, first, last) - points_[first]);
        std::vector<Part> parts{{first, last, first == 0 ? start_.value_or(start) : start,
                                 unit(points_[last] - beyond(last, -1, first, last))}};
        while (!parts.empty()) {
            const Part part = parts.back();
            parts.pop_back();
            const std::size_t split = add(part);
            if (split == part.first) {
                if (part.last != last)
                    pieces_.back().on = part.end;
                continue;
            }
            const Point along =
                unit(beyond(split, 1, first, last) - beyond(split, -1, first, last));
            parts.push_back({split, part.last, along, part.end});
            parts.push_back({part.first, split, part.start, along});
        }
    }
    /// Adds the part as one curve; otherwise returns where to split it.
    std::size_t add(const Part& part)
    {
        if (part.last - part.first > mostPoints)
            return (part.first + part.last) / 2;
        const Bezier curve = curveOf(part);
        const std::size_t worst = farthest(curve, part);
        if (worst != part.first)
            return worst;
        pieces_.push_back({{curve.to, curve.control1, curve.control2, true}, part.last, {}});
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

    std::span<const Point> points_;
    double tolerance_;
    std::optional<Point> start_;
    std::vector<Piece> pieces_;
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

Freehand::Freehand(const Point& start, double tolerance)
    : tolerance_(tolerance), done_{start, {}, false}, few_{start}, later_{start}
{
}

void Freehand::add(const Point& point)
{
    later_.push_back(point);
    if (later_.size() <= atOnce)
        return;
    few_ = reduced();
    later_ = {point};
    if (few_.size() > waiting)
        fit(few_.size() - waiting / 2);
}

std::vector<Point> Freehand::reduced() const
{
    std::vector<Point> all = few_;
    const auto more = dense(simplified(later_, forPoints * tolerance_), apart * tolerance_);
    all.insert(all.end(), more.begin() + 1, more.end());
    return all;
}

void Freehand::fit(std::size_t before)
{
    std::size_t last = 0;
    for (const Piece& piece : Fit(few_, tolerance_, direction_).pieces()) {
        if (piece.last > before)
            break;
        done_.segments.push_back(piece.segment);
        direction_ = piece.on;
        last = piece.last;
    }
    few_.erase(few_.begin(), few_.begin() + std::ptrdiff_t(last));
}

Subpath Freehand::path() const
{
    const auto few = reduced();
    if (done_.segments.empty() && simplified(few, forPoints * tolerance_).size() == 2)
        return {few.front(), {{few.back()}}, false};
    Subpath path = done_;
    for (const Piece& piece : Fit(few, tolerance_, direction_).pieces())
        path.segments.push_back(piece.segment);
    return path;
}

Subpath Freehand::draft() const
{
    Subpath path = done_;
    for (std::size_t i = 1; i < few_.size(); ++i)
        path.segments.push_back({few_[i]});
    for (std::size_t i = 1; i < later_.size(); ++i)
        path.segments.push_back({later_[i]});
    return path;
}

Subpath smoothed(std::span<const Point> stroke, double tolerance)
{
    Freehand freehand(stroke.front(), tolerance);
    for (const Point& point : stroke.subspan(1))
        freehand.add(point);
    return freehand.path();
}

} // namespace app

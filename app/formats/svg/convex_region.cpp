// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/convex_region.h"

#include "app/document/path.h"
#include "app/formats/svg/limits.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app::svg {
namespace {

using clipping::Edge;

double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }

std::vector<Point> cornersOf(const Subpath& path, double tolerance)
{
    std::vector<Chord> chords;
    flatten(path, tolerance, chords);
    std::vector<Point> corners;
    for (const Chord& chord : chords)
        if (corners.empty() || corners.back() != chord.segment.a)
            corners.push_back(chord.segment.a);
    if (!chords.empty() && chords.back().segment.b != corners.back())
        corners.push_back(chords.back().segment.b);
    while (corners.size() > 1 && corners.back() == corners.front())
        corners.pop_back();
    return corners;
}

// Returns the sign of the turns if the outline goes round exactly once and always turns to the same
// side; otherwise 0. Sides that double back, and bends of a curve within rounding error, are
// ignored.
int turning(const std::vector<Point>& corners)
{
    const std::size_t n = corners.size();
    double sum = 0;
    int sign = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Point in = corners[(i + 1) % n] - corners[i];
        const Point out = corners[(i + 2) % n] - corners[(i + 1) % n];
        const double angle = std::atan2(cross(in, out), dot(in, out));
        sum += angle;
        if (std::abs(angle) < 1e-6)
            continue;
        const int turn = angle > 0 ? 1 : -1;
        if (sign != 0 && turn != sign)
            return 0;
        sign = turn;
    }
    return std::abs(std::abs(sum) - 2 * std::numbers::pi) < 1e-3 ? sign : 0;
}

bool isFlat(const std::vector<Point>& corners)
{
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        if (cross(corners[i] - corners[0], corners[i + 1] - corners[0]) != 0)
            return false;
    return true;
}

} // namespace

std::optional<ConvexRegion> ConvexRegion::of(const Subpath& path, double tolerance)
{
    if (path.segments.size() > mostClipSides)
        return std::nullopt;
    ConvexRegion region;
    region.corners_ = cornersOf(path, tolerance);
    if (isFlat(region.corners_)) {
        region.corners_.clear();
        return region;
    }
    const int sign = turning(region.corners_);
    if (sign == 0 || region.corners_.size() > mostClipSides)
        return std::nullopt;
    if (sign < 0)
        std::ranges::reverse(region.corners_);
    return region;
}

clipping::Window ConvexRegion::bounds() const
{
    clipping::Window box{corners_.front(), corners_.front()};
    for (const Point& corner : corners_)
        box = {glm::min(box.min, corner), glm::max(box.max, corner)};
    return box;
}

double ConvexRegion::height(std::size_t side, const Point& p) const
{
    return cross(next(side) - corners_[side], p - corners_[side]);
}

std::optional<clipping::Segment> ConvexRegion::sideAt(const Point& p) const
{
    constexpr double rounding = 1e-9;
    for (std::size_t side = 0; side < corners_.size(); ++side) {
        const Point along = next(side) - corners_[side];
        const double length = std::hypot(along.x, along.y);
        const double slack = rounding * (length + std::hypot(p.x, p.y));
        if (std::abs(height(side, p)) <= slack * length)
            return clipping::Segment{corners_[side], next(side)};
    }
    return std::nullopt;
}

Edge ConvexRegion::edge(std::size_t side) const
{
    const Point along = next(side) - corners_[side];
    return along.x == 0 ? Edge::Left : along.y == 0 ? Edge::Bottom : Edge::NoEdge;
}

Point ConvexRegion::crossing(std::size_t side, const Point& a, const Point& b) const
{
    const double ha = height(side, a), hb = height(side, b);
    Point p = a + (b - a) * (ha / (ha - hb));
    if (edge(side) == Edge::Left)
        p.x = corners_[side].x;
    if (edge(side) == Edge::Bottom)
        p.y = corners_[side].y;
    return p;
}

ConvexRegion::Position ConvexRegion::position(const Subpath& path) const
{
    bool inside = !corners_.empty();
    for (std::size_t side = 0; side < corners_.size(); ++side) {
        std::size_t above = 0, below = 0;
        forEachPoint(path, [&](const Point& p) { ++(height(side, p) >= 0 ? above : below); });
        if (above == 0)
            return Position::Outside;
        inside = inside && below == 0;
    }
    return inside ? Position::Inside : corners_.empty() ? Position::Outside : Position::Across;
}

std::optional<KeptPart> ConvexRegion::clip(const Chord& chord, std::size_t index) const
{
    const auto& [a, b] = chord.segment;
    double enter = 0, leave = 1;
    std::size_t enterSide = 0, leaveSide = 0;
    for (std::size_t side = 0; side < corners_.size(); ++side) {
        const double ha = height(side, a), hb = height(side, b);
        if (ha < 0 && hb < 0)
            return std::nullopt;
        const double t = ha / (ha - hb);
        if (ha < 0 && t >= enter) {
            enter = t;
            enterSide = side;
        } else if (hb < 0 && t <= leave) {
            leave = t;
            leaveSide = side;
        }
    }
    if (corners_.empty() || enter > leave || (enter == leave && a != b))
        return std::nullopt;
    KeptPart part{index, chord.segment};
    if (enter > 0) {
        part.segment.a = crossing(enterSide, a, b);
        part.edgeA = edge(enterSide);
    }
    if (leave < 1) {
        part.segment.b = crossing(leaveSide, a, b);
        part.edgeB = edge(leaveSide);
    }
    if (a != b && part.segment.a == part.segment.b)
        return std::nullopt;
    return part;
}

std::vector<Point> ConvexRegion::clip(std::vector<Point> polygon) const
{
    if (corners_.empty())
        return {};
    for (std::size_t side = 0; side < corners_.size() && !polygon.empty(); ++side) {
        std::vector<Point> kept;
        Point last = polygon.back();
        bool lastInside = height(side, last) >= 0;
        for (const Point& p : polygon) {
            const bool inside = height(side, p) >= 0;
            if (inside != lastInside)
                kept.push_back(crossing(side, last, p));
            if (inside)
                kept.push_back(p);
            last = p;
            lastInside = inside;
        }
        kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
        polygon = std::move(kept);
    }
    return polygon;
}

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/stroke_rings.h"

#include "app/cut/offset_curve.h"
#include "app/document/arc_curves.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

/// A line or a curve of the path.
struct Piece {
    DirectedCurve along;
    bool curved;
};

/// The direction towards the first of the points that is another one.
std::optional<Point> directionOf(const Point& from, std::initializer_list<Point> towards)
{
    for (const Point& p : towards)
        if (const double length = glm::distance(from, p); length > 0)
            return (p - from) / length;
    return std::nullopt;
}

void append(std::vector<Piece>& pieces, const Point& from, const PathSegment& segment)
{
    const auto& [to, control1, control2, curved] = segment;
    const Bezier curve = curved ? Bezier{from, control1, control2, to} : Bezier{from, from, to, to};
    const auto first = directionOf(from, {curve.control1, curve.control2, to});
    const auto last = directionOf(to, {curve.control2, curve.control1, from});
    if (first && last)
        pieces.push_back({{curve, *first, -*last}, curved});
}

std::vector<Piece> piecesOf(const Subpath& path)
{
    std::vector<Piece> pieces;
    Point at = path.start;
    for (const PathSegment& segment : path.segments) {
        append(pieces, at, segment);
        at = segment.to;
    }
    if (path.closed)
        append(pieces, at, {path.start});
    return pieces;
}

class StrokeRings {
public:
    StrokeRings(const Style& style, double tolerance)
        : style_(style), tolerance_(tolerance), half_(style.width / 2)
    {
    }

    void addPiece(const Piece& piece)
    {
        if (piece.curved)
            addCurve(piece.along, 0);
        else
            addLine(piece.along);
    }

    /// Between two pieces that meet at p.
    void addJoin(const Point& p, const Point& before, const Point& after, Join join)
    {
        const double turn = cross(before, after), ahead = glm::dot(before, after);
        const double sign = turn > 0 ? 1 : -1; // back on itself, a path turns to either side
        const double outside = -sign * half_;  // the side that the turn leaves open
        const Point from = normalOf(before) * outside, to = normalOf(after) * outside;
        if (join == Join::Round)
            return addSector(p, from, to, sign * std::atan2(std::abs(turn), ahead));
        Subpath wedge{p, {{p + from}}, true};
        // The tip is at half the width divided by the cosine of half the turn.
        if (join == Join::Miter && 2 <= style_.miterLimit * style_.miterLimit * (1 + ahead))
            wedge.segments.push_back({p + (from + to) / (1 + ahead)});
        wedge.segments.push_back({p + to});
        add(std::move(wedge));
    }

    /// At p, where the path ends in a direction.
    void addCap(const Point& p, const Point& outwards)
    {
        const Point side = normalOf(outwards) * half_;
        if (style_.cap == Cap::Round)
            return addSector(p, side, -side, -std::numbers::pi);
        if (style_.cap == Cap::Butt)
            return;
        const Point far = p + outwards * half_;
        add({p + side, {{far + side}, {far - side}, {p - side}}, true});
    }

    std::vector<Subpath> take() { return std::move(rings_); }

private:
    void addLine(const DirectedCurve& line)
    {
        const Point side0 = normalOf(line.direction0) * half_;
        const Point side1 = normalOf(line.direction1) * half_;
        const Point &from = line.curve.from, &to = line.curve.to;
        add({from + side0, {{to + side1}, {to - side1}, {from - side0}}, true});
    }

    void addCurve(const DirectedCurve& of, int depth)
    {
        constexpr int deepest = 40;
        const auto left = offsetCurve(of, half_, tolerance_);
        const auto right = left ? offsetCurve(of, -half_, tolerance_) : left;
        if (left && right)
            return addBothSides(of, *left, *right);
        const Bezier& curve = of.curve;
        if (depth == deepest || !(sizeOf(curve) > tolerance_))
            return addPoint(of);
        const Bezier first = curve.part(0, 0.5), second = curve.part(0.5, 1);
        const auto middle = directionOf(first.to, {second.control1, second.control2, second.to});
        if (!middle)
            return addPoint(of);
        addCurve({first, of.direction0, *middle}, depth + 1);
        addCurve({second, *middle, of.direction1}, depth + 1);
    }

    static double sizeOf(const Bezier& curve)
    {
        return std::max({glm::distance(curve.from, curve.control1),
                         glm::distance(curve.from, curve.control2),
                         glm::distance(curve.from, curve.to)});
    }

    /// Of a curve no larger than the tolerance: a line and a turn.
    void addPoint(const DirectedCurve& of)
    {
        const Bezier& curve = of.curve;
        addLine({curve, of.direction0, of.direction0});
        addJoin(curve.to, of.direction0, of.direction1, Join::Round);
    }

    void addBothSides(const DirectedCurve& of, const OffsetCurve& left, const OffsetCurve& right)
    {
        const Bezier &l = left.curve, &r = right.curve;
        if (!left.isReversed && !right.isReversed)
            return add({l.from,
                        {{l.to, l.control1, l.control2, true},
                         {r.to},
                         {r.from, r.control2, r.control1, true}},
                        true});
        addSide(of, left, half_);
        addSide(of, right, -half_);
    }

    /// Between the curve's chord and the curve beside it.
    void addSide(const DirectedCurve& of, const OffsetCurve& side, double distance)
    {
        const Point &from = of.curve.from, &to = of.curve.to;
        const Bezier& beside = side.curve;
        const PathSegment back{beside.from, beside.control2, beside.control1, true};
        if (!side.isReversed)
            return add({from, {{to}, {beside.to}, back}, true});
        // The normals cross at the centre of curvature: two triangles with their tips there. Each
        // reaches beyond it, by what is not seen, so that no gap opens between it and the next one.
        constexpr double beyond = 1e-6;
        const Point normal0 = normalOf(of.direction0) * distance,
                    normal1 = normalOf(of.direction1) * distance;
        const double along = cross(to - from, normal1) / cross(normal0, normal1);
        const Point centre = from + normal0 * along;
        const Point further = (normal0 + normal1) * beyond;
        add({from, {{to}, {centre + further}}, true});
        add({centre - further, {{beside.to}, back}, true});
    }

    /// A part of the disc around p.
    void addSector(const Point& p, const Point& from, const Point& to, double sweep)
    {
        Subpath sector{p, {{p + from}}, true};
        // A curve for a quarter turn is off by 0.03 % of the radius, one for half of that by
        // nothing.
        const bool isLarge = 3e-4 * half_ > tolerance_ && std::abs(sweep) > 0.7;
        const int parts = isLarge ? int(std::ceil(std::abs(sweep) / (std::numbers::pi / 4))) : 1;
        const EllipseArc arc{p, {half_, 0}, {0, half_}, std::atan2(from.y, from.x), sweep / parts};
        for (int i = 0; i < parts; ++i) {
            const double angle = arc.angle + i * arc.sweep;
            appendCurves(sector.segments, {p, arc.axis1, arc.axis2, angle, arc.sweep},
                         sector.segments.back().to,
                         i + 1 == parts ? p + to : arc.at(angle + arc.sweep));
        }
        add(std::move(sector));
    }

    /// All rings get the same direction.
    void add(Subpath ring)
    {
        double area = 0;
        Point before{};
        for (const PathSegment& segment : ring.segments) {
            const Point at = segment.to - ring.start;
            area += cross(before, at);
            before = at;
        }
        if (area > 0)
            ring = reversedPath(ring);
        rings_.push_back(std::move(ring));
    }

    const Style& style_;
    const double tolerance_;
    const double half_;
    std::vector<Subpath> rings_;
};

/// Whether one goes on where the other ends, apart from rounding.
bool isSmooth(const Point& before, const Point& after)
{
    constexpr double leastTurn = 1e-6;
    return std::abs(cross(before, after)) < leastTurn && glm::dot(before, after) > 0;
}

} // namespace

std::vector<Subpath> strokeRings(const Subpath& path, const Style& style, double tolerance)
{
    StrokeRings rings(style, tolerance);
    std::vector<Piece> pieces = piecesOf(path);
    if (pieces.empty()) { // a point
        rings.addCap(path.start, {1, 0});
        rings.addCap(path.start, {-1, 0});
        return rings.take();
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const bool isLast = i + 1 == pieces.size();
        if (isLast && !path.closed)
            break;
        DirectedCurve &along = pieces[i].along, &next = pieces[isLast ? 0 : i + 1].along;
        if (isSmooth(along.direction1, next.direction0))
            (isLast ? along.direction1 : next.direction0) =
                isLast ? next.direction0 : along.direction1;
        else
            rings.addJoin(next.curve.from, along.direction1, next.direction0, style.join);
    }
    for (const Piece& piece : pieces)
        rings.addPiece(piece);
    if (!path.closed) {
        rings.addCap(pieces.front().along.curve.from, -pieces.front().along.direction0);
        rings.addCap(pieces.back().along.curve.to, pieces.back().along.direction1);
    }
    return rings.take();
}

} // namespace app

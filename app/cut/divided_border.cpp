// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/curve_at_edge.h"
#include "app/cut/curved_border.h"
#include "app/cut/whole_curve.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <iterator>
#include <limits>

namespace app {
void CurvedBorder::divideAtEndsIn(const Objects& objects, const std::stop_token& stop)
{
    if (isEmpty())
        return;
    Cuts cuts;
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        if (!stop.stop_requested())
            divideAtEndsOf(object.path(), cuts);
    });
    divide(cuts);
}

/// Where the border of one window begins or ends on that of another one.
void CurvedBorder::divideAtEndsOfWindows()
{
    Cuts cuts;
    for (const std::size_t i : curved_)
        divideAtEndsOf(std::get<PathShape>(windows_.list[i].shape).path, cuts);
    divide(cuts);
}

void CurvedBorder::divideAtEndsOf(const Path& path, Cuts& cuts)
{
    if (path.straight())
        return path.forEachPoint([&](const Point& p) { divideAt(p, p, cuts); });
    for (const Subpath& subpath : path.subpaths()) {
        divideAt(subpath.start, subpath.start, cuts);
        for (std::size_t i = 0; i < subpath.segments.size(); ++i) {
            const Point to = subpath.segments[i].to;
            const bool goesOn = isCurve(subpath, i) && goesOnAfter(subpath, i);
            const auto ellipse = goesOn ? ellipseAt(subpath, i) : std::nullopt;
            divideAt(to, ellipse ? onEllipse(*ellipse, to) : to, cuts);
        }
    }
}

/// Whether an edge begins beside a point of its ellipse, as far from it as drawings of one ellipse
/// are, where no curve ends. A short edge between the two would be along no curve.
bool CurvedBorder::mayMove(const Edge& edge, const Point& p) const
{
    if (!edge.isCurved())
        return false;
    const auto& ellipse = sourceOf(edge).ellipse;
    return ellipse && !edge.isEnd && glm::distance(edge.from, p) <= drawnOff(ellipse)
           && glm::distance(onEllipse(*ellipse, p), p) <= near_;
}

/// Ends an edge at a point, where the next one begins.
void CurvedBorder::move(Edge& before, Edge& edge, const Point& p) const
{
    edge.from = p;
    edge.isEnd = true;
    // Of an ellipse, the end of its turn is also its start.
    before.t1 = sourceOf(edge).curve.near(p, before.t1);
    edge.t0 = sourceOf(edge).curve.near(p, edge.t0);
}

/// Where a corner of the border is the point but for rounding, it becomes the point.
void CurvedBorder::divideAt(const Point& p, const Point& on, Cuts& cuts)
{
    std::map<std::size_t, std::pair<std::uint32_t, Where>> nearest; // of each ring
    index_.meeting({on, on}, 0, [&](std::uint32_t number) {
        const Place& place = edges_[number];
        auto& edges = rings_[place.ring].edges;
        const std::size_t after = (place.edge + 1) % edges.size();
        for (Edge* edge : {&edges[place.edge], &edges[after]})
            if (areSame(edge->from, p)) {
                cuts.moved = cuts.moved || edge->from != p;
                edge->from = p;
                edge->isEnd = true;
            }
        if (mayMove(edges[after], on)) {
            move(edges[place.edge], edges[after], p);
            cuts.moved = true;
        }
        if (placeOn(edgeAt(place).from, endOf(place), on).distance
            > tolerance_ + 2 * near_ + strayOf(endOf(place) - edgeAt(place).from, tolerance_))
            return;
        const Where where = whereOn(place, on);
        const auto [at, isFirst] = nearest.try_emplace(place.ring, number, where);
        if (!isFirst && where.distance < at->second.second.distance)
            at->second = {number, where};
    });
    for (const auto& [ring, found] : nearest) {
        const auto& [number, where] = found;
        const Place& place = edges_[number];
        if (where.distance <= 1.5 * near_ // the parts of edges themselves are off by some of that
            && edgeAt(place).from != p && endOf(place) != p)
            cuts.on[number].push_back(p);
    }
}

CurvedBorder::Where CurvedBorder::placeOn(const Point& a, const Point& b, const Point& p)
{
    const Point along = b - a;
    const double length = glm::dot(along, along);
    const double share = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0;
    return {share, glm::distance(a + along * share, p)};
}

CurvedBorder::Where CurvedBorder::whereOn(const Place& place, const Point& p) const
{
    const Edge& edge = edgeAt(place);
    std::vector<Point> points{edge.from};
    std::ranges::copy(between(edge), std::back_inserter(points));
    points.push_back(endOf(place));
    Where where{0, std::numeric_limits<double>::infinity()};
    const auto look = [&] {
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const auto [share, distance] = placeOn(points[i], points[i + 1], p);
            if (distance < where.distance)
                where = {double(i) + share, distance};
        }
    };
    look();
    if (const auto& ellipse = sourceOf(edge).ellipse) {
        for (Point& q : points)
            q = onEllipse(*ellipse, q);
        look();
    }
    return where;
}

/// The parts of an edge between points on it, in their order.
std::vector<CurvedBorder::Edge> CurvedBorder::divided(const Edge& edge,
                                                      std::span<const Point> points) const
{
    const auto [low, high] = std::minmax(edge.t0, edge.t1);
    std::vector<std::pair<double, Point>> places;
    for (const Point& p : points)
        places.emplace_back(std::clamp(sourceOf(edge).curve.near(p, edge.t0), low, high), p);
    std::ranges::stable_sort(places, [&](const auto& a, const auto& b) {
        return edge.t0 < edge.t1 ? a.first < b.first : b.first < a.first;
    });
    std::vector<Edge> parts{edge};
    for (const auto& [t, p] : places)
        if (!areSame(p, parts.back().from)) {
            parts.back().t1 = t;
            parts.push_back({p, t, edge.t1, edge.source, true});
        }
    return parts;
}

void CurvedBorder::divide(const Cuts& cuts)
{
    if (cuts.on.empty() && !cuts.moved)
        return;
    std::vector<Ring> rings;
    for (const Ring& ring : rings_)
        rings.push_back({ring.window});
    std::uint32_t number = 0; // of the next curved edge
    for (std::size_t i = 0; i < rings_.size(); ++i)
        for (const Edge& edge : rings_[i].edges) {
            auto& edges = rings[i].edges;
            const auto found = edge.isCurved() ? cuts.on.find(number++) : cuts.on.end();
            if (found == cuts.on.end()) {
                edges.push_back(edge);
                continue;
            }
            std::ranges::move(divided(edge, found->second), std::back_inserter(edges));
        }
    rings_ = std::move(rings);
    makeIndex();
}

} // namespace app

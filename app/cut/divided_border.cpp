// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/curve_at_edge.h"
#include "app/cut/curved_border.h"
#include "app/cut/whole_curve.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace app {
void CurvedBorder::divideAtEndsIn(const Objects& objects, const std::stop_token& stop)
{
    if (isEmpty())
        return;
    Cuts cuts;
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        if (!object.singleLine() && !object.path().straight() && !stop.stop_requested())
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
    for (const Subpath& subpath : path.subpaths())
        for (std::size_t i = 0; i < subpath.segments.size(); ++i)
            if (isCurve(subpath, i)) {
                const Point from = curveOf(subpath, i).from, to = subpath.segments[i].to;
                if (i == 0 || !isCurve(subpath, i - 1))
                    divideAt(from, from, cuts);
                const auto ellipse = goesOnAfter(subpath, i) ? ellipseAt(subpath, i) : std::nullopt;
                divideAt(to, ellipse ? onEllipse(*ellipse, to) : to, cuts);
            }
}

/// Whether an edge begins beside a point of its ellipse, as far from it as drawings of one ellipse
/// are, where no curve ends. A short edge between the two would be along no curve.
bool CurvedBorder::mayMove(const Edge& edge, const Point& p) const
{
    const auto& ellipse = edge.ellipse;
    return ellipse && !edge.isEnd && glm::distance(edge.from, p) <= drawnOff(ellipse)
           && glm::distance(onEllipse(*ellipse, p), p) <= near_;
}

/// Ends an edge at a point, where the next one begins.
void CurvedBorder::move(Edge& before, Edge& edge, const Point& p) const
{
    edge.from = p;
    edge.isEnd = true;
    // Of an ellipse, the end of its turn is also its start.
    before.t1 = sources_[edge.source].near(p, before.t1);
    edge.t0 = sources_[edge.source].near(p, edge.t0);
    followCurve(before);
    followCurve(edge);
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
                edge->from = p;
                edge->isEnd = true;
            }
        if (mayMove(edges[after], on))
            move(edges[place.edge], edges[after], p);
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
            cuts[number].emplace_back(where.parts, p);
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
    points.insert(points.end(), edge.between.begin(), edge.between.end());
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
    if (edge.ellipse) {
        for (Point& q : points)
            q = onEllipse(*edge.ellipse, q);
        look();
    }
    return where;
}

/// Ends an edge at a point, and begins the next.
CurvedBorder::Edge CurvedBorder::partFrom(Edge& edge, const Point& p) const
{
    Edge part{p, {}, edge.ellipse, true, edge.source, edge.t0, edge.t1, true};
    const auto [low, high] = std::minmax(edge.t0, edge.t1);
    edge.t1 = part.t0 = std::clamp(sources_[edge.source].near(p, edge.t0), low, high);
    return part;
}

void CurvedBorder::divide(Cuts& cuts)
{
    std::vector<Ring> divided;
    for (const Ring& ring : rings_)
        divided.push_back({ring.window});
    std::uint32_t number = 0; // of the next curved edge
    for (std::size_t i = 0; i < rings_.size(); ++i)
        for (const Edge& edge : rings_[i].edges) {
            auto& edges = divided[i].edges;
            const auto found = edge.isCurved ? cuts.find(number++) : cuts.end();
            if (found == cuts.end()) {
                edges.push_back(edge);
                continue;
            }
            auto& places = found->second;
            std::ranges::sort(places, {}, &std::pair<double, Point>::first);
            const std::size_t first = edges.size();
            edges.push_back(edge);
            for (const auto& [where, p] : places)
                if (!areSame(p, edges.back().from))
                    edges.push_back(partFrom(edges.back(), p));
            for (Edge& part : std::span(edges).subspan(first))
                followCurve(part);
        }
    rings_ = std::move(divided);
    makeIndex();
}

} // namespace app

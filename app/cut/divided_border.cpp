// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/background.h"
#include "app/base/in_parallel.h"
#include "app/cut/curved_border.h"
#include "app/cut/true_curve.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <iterator>
#include <limits>

namespace app {
void CurvedBorder::divideFor(const Objects& objects, double tolerance, const std::stop_token& stop)
{
    if (isEmpty())
        return;
    Cuts ends;
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        if (!stop.stop_requested())
            divideAtEndsOf(object.path(), ends);
    });
    divide(ends);
    constexpr std::size_t atOnce = 512;
    std::vector<Cuts> touches((objects.size() + atOnce - 1) / atOnce);
    inParallel(paintingThreads(), workersOf(paintingThreads()), touches.size(),
               [&](std::size_t i, std::size_t) {
                   objects.forEach(i * atOnce, std::min(atOnce, objects.size() - i * atOnce),
                                   [&](std::size_t, const ObjectView& object) {
                                       if (!stop.stop_requested())
                                           addTouchesOf(object, tolerance, touches[i]);
                                   });
               });
    Cuts all;
    for (Cuts& each : touches)
        for (auto& [edge, cuts] : each.on)
            std::ranges::move(cuts, std::back_inserter(all.on[edge]));
    divide(all);
}

/// Where the border of one window begins or ends on that of another one.
void CurvedBorder::divideAtEndsOfWindows()
{
    Cuts cuts;
    for (const std::size_t i : withRings_)
        divideAtEndsOf(std::get<PathShape>(windows_.list[i].shape).path, cuts);
    divide(cuts);
}

void CurvedBorder::divideAtEndsOf(const Path& path, Cuts& cuts)
{
    if (path.straight())
        return path.forEachPoint([&](const Point& p) { divideAt(p, Ending::Line, cuts); });
    if (!isBeside(path))
        return;
    for (const Subpath& subpath : path.subpaths()) {
        if (!isCurve(subpath, 0))
            divideAt(subpath.start, Ending::Line, cuts);
        for (std::size_t i = 0; i < subpath.segments.size(); ++i)
            if (isCurve(subpath, i)) {
                const TrueCurve curve = curveAt(subpath, i);
                divideAt(curve.at(0), Ending::Curve, cuts);
                divideAt(curve.at(1), Ending::Curve, cuts);
            } else {
                divideAt(subpath.segments[i].to, Ending::Line, cuts);
            }
    }
}

/// Whether an edge ends so near to a point of its curve that a short edge between the two would be
/// along no curve. Corners where something ends stay.
bool CurvedBorder::mayMoveEnd(const Place& place, const Point& p) const
{
    const Edge& next = edgeAt(after(place));
    if (!next.isCurved() || next.isEnd)
        return false;
    const double distance = glm::distance(next.from, p);
    constexpr double little = 0.25; // the edges beside it must stay near to the curve
    if (distance > little * glm::distance(edgeAt(place).from, next.from)
        || distance > little * glm::distance(next.from, endOf(after(place))))
        return false;
    if (distance > 3 * near_)
        return false;
    const Point before = cornerOn(place, p).on, behind = cornerOn(after(place), p).on;
    const Point on = glm::distance(before, p) < glm::distance(behind, p) ? before : behind;
    return glm::distance(on, p) <= near_
           && glm::distance(next.from, on) <= 2 * glm::distance(on, p);
}

/// Ends an edge at a point, where the next one begins. Their parameters stay: it is very near.
void CurvedBorder::moveEnd(const Place& place, const Point& p)
{
    auto& edges = rings_[place.ring].edges;
    Edge& next = edges[after(place).edge];
    next.from = p;
    next.isEnd = true;
}

/// Where a corner of the border is the point but for rounding, it becomes the point.
void CurvedBorder::divideAt(const Point& p, Ending ending, Cuts& cuts)
{
    std::map<std::size_t, std::pair<double, std::uint32_t>> nearest; // of each ring
    index_.meeting({p, p}, 0, [&](std::uint32_t number) {
        const Place& place = edges_[number];
        if (ending == Ending::Line && !edgeAt(place).isCurved())
            return;
        auto& edges = rings_[place.ring].edges;
        for (Edge* edge : {&edges[place.edge], &edges[after(place).edge]})
            if (areSame(edge->from, p) && !edge->isEnd) {
                cuts.moved = cuts.moved || edge->from != p;
                edge->from = p;
                edge->isEnd = true;
            }
        if (mayMoveEnd(place, p)) {
            moveEnd(place, p);
            cuts.moved = true;
        }
        if (placeOn(edgeAt(place).from, endOf(place), p).distance > tolerance_ + 2 * near_)
            return;
        const std::pair found(glm::distance(cornerOn(place, p).on, p), number);
        const auto at = nearest.try_emplace(place.ring, found).first;
        if (found.first < at->second.first)
            at->second = found;
    });
    for (const auto& [ring, found] : nearest) {
        const auto& [distance, number] = found;
        const Place& place = edges_[number];
        if (distance <= 1.5 * near_ && edgeAt(place).from != p && endOf(place) != p)
            cuts.on[number].push_back({p, ending});
    }
}

CurvedBorder::Where CurvedBorder::placeOn(const Point& a, const Point& b, const Point& p)
{
    const Point along = b - a;
    const double length = glm::dot(along, along);
    const double share = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0;
    return {share, glm::distance(a + along * share, p)};
}

CurvedBorder::Corner CurvedBorder::cornerOn(const Place& place, const Point& p) const
{
    const Edge& edge = edgeAt(place);
    if (!edge.isCurved()) {
        const double share = placeOn(edge.from, endOf(place), p).share;
        return {share, p, edge.from + (endOf(place) - edge.from) * share};
    }
    const double t = sourceOf(edge).near(p, edge.t0, edge.t1);
    return {t, p, sourceOf(edge).at(t)};
}

/// The parts of an edge between points on it, in their order. Of two points beside each other, only
/// the first counts: a curve that runs along the border would not pass both.
std::vector<CurvedBorder::Edge> CurvedBorder::divided(const Place& place,
                                                      std::span<const Cut> cuts) const
{
    const Edge& edge = edgeAt(place);
    std::vector<Corner> corners;
    for (const auto& [at, ending] : cuts) {
        corners.push_back(cornerOn(place, at));
        corners.back().ending = ending;
    }
    std::ranges::stable_sort(corners, [&](const Corner& a, const Corner& b) {
        return edge.t0 <= edge.t1 ? a.t < b.t : b.t < a.t;
    });
    // Curves may begin beside the joints of curves, as far as another drawing of one is.
    const auto areCurves = [&](const Corner& joint, const Corner& corner) {
        return (joint.t == 0 || joint.t == 1) && corner.ending == Ending::Curve;
    };
    const auto goesOn = [&](const Corner& a, const Corner& b) {
        return !areSame(a.at, b.at)
               && (areCurves(a, b) || areCurves(b, a)
                   || glm::distance(a.on, b.on) > 2 * glm::distance(a.at - a.on, b.at - b.on));
    };
    const auto ownCorner = [&](double t, const Point& at) {
        return Corner{t, at, edge.isCurved() ? sourceOf(edge).at(t) : at};
    };
    Corner last = ownCorner(edge.t0, edge.from);
    const Corner end = ownCorner(edge.isCurved() ? edge.t1 : 1, endOf(place));
    std::vector<Edge> parts{edge};
    for (const Corner& corner : corners)
        if (goesOn(last, corner) && goesOn(corner, end)) {
            last = corner;
            parts.push_back(edge);
            parts.back().from = corner.at;
            parts.back().isEnd = true;
            if (edge.isCurved())
                parts[parts.size() - 2].t1 = parts.back().t0 = corner.t;
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
    std::uint32_t number = 0; // of the next edge that may be divided
    for (std::size_t i = 0; i < rings_.size(); ++i)
        for (std::size_t j = 0; j < rings_[i].edges.size(); ++j) {
            auto& edges = rings[i].edges;
            const Edge& edge = rings_[i].edges[j];
            const auto found = edge.isStraight() ? cuts.on.end() : cuts.on.find(number++);
            if (found == cuts.on.end())
                edges.push_back(edge);
            else
                std::ranges::move(divided({i, j}, found->second), std::back_inserter(edges));
        }
    rings_ = std::move(rings);
    makeIndex();
}

} // namespace app

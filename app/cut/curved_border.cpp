// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/curved_border.h"

#include "app/cut/curve_at_edge.h"
#include "app/document/direction.h"
#include "app/document/window_outline.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {
namespace {

constexpr double justAfterStart = 1e-300; // only a subpath's first chord begins at 0
constexpr int between = 8; // parts of an edge, each 64 times nearer to its curve than the edge

clipping::Window grown(const clipping::Window& box, double by)
{
    return {box.min - by, box.max + by};
}

clipping::Window boxAround(const Point& p, const Point& q)
{
    return {glm::min(p, q), glm::max(p, q)};
}

/// The share of the way along a segment that is nearest to a point, and the distance there.
std::pair<double, double> placeOn(const Point& a, const Point& b, const Point& p)
{
    const Point along = b - a;
    const double length = glm::dot(along, along);
    const double share = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0;
    return {share, glm::distance(a + along * share, p)};
}

bool isCurvedWindow(const ClipWindow& window)
{
    const auto* shape = std::get_if<PathShape>(&window.shape);
    return window.visible && shape && !shape->path.straight();
}

} // namespace

CurvedBorder::CurvedBorder(const ClipWindows& windows, const Page& page)
    : windows_(windows), near_(millimetres / page.millimetresPerUnit())
{
    const double tolerance = windowMillimetres / page.millimetresPerUnit();
    for (std::size_t i = 0; i < windows.list.size(); ++i)
        if (isCurvedWindow(windows.list[i]))
            add(std::get<PathShape>(windows.list[i].shape), tolerance, i);
    makeIndex();
}

void CurvedBorder::add(const PathShape& shape, double tolerance, std::size_t window)
{
    if (const auto* round = std::get_if<EllipseRecipe>(&shape.recipe)) {
        const Point radii = glm::abs(round->radii);
        const EllipseArc ellipse{round->centre, {radii.x, 0}, {0, radii.y}};
        Ring& ring = rings_.emplace_back(Ring{window});
        const std::vector<Point> corners = outlineOf(shape, tolerance).rings.front();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            Edge edge{corners[i], {}, ellipse, true};
            for (int k = 1; k < between; ++k) {
                const double share = (double(i) + double(k) / between) / double(corners.size());
                edge.between.push_back(round->centre + radii * directionOf(-360 * share));
            }
            ring.edges.push_back(std::move(edge));
        }
        return;
    }
    for (const Subpath& path : shape.path.subpaths()) {
        std::vector<Chord> chords;
        flatten(path, tolerance, chords);
        Ring& ring = rings_.emplace_back(Ring{window});
        for (const Chord& chord : chords) {
            Edge edge{chord.segment.a};
            if (edge.isCurved = isCurve(path, chord.pathSegment); edge.isCurved) {
                const Bezier curve = curveOf(path, chord.pathSegment);
                edge.ellipse = ellipseOf(curve);
                for (int k = 1; k < between; ++k)
                    edge.between.push_back(
                        curve.at(chord.t0 + (chord.t1 - chord.t0) * k / between));
            }
            if (chord.segment.a != chord.segment.b)
                ring.edges.push_back(std::move(edge));
        }
        if (const Point end = chords.back().segment.b; end != chords.front().segment.a)
            ring.edges.push_back({end}); // an open path counts as closed
    }
}

const Point& CurvedBorder::endOf(const Place& place) const
{
    const auto& edges = rings_[place.ring].edges;
    return edges[(place.edge + 1) % edges.size()].from;
}

void CurvedBorder::makeIndex()
{
    edges_.clear();
    std::vector<clipping::Window> boxes;
    for (std::size_t i = 0; i < rings_.size(); ++i)
        for (std::size_t j = 0; j < rings_[i].edges.size(); ++j) {
            const Edge& edge = rings_[i].edges[j];
            if (!edge.isCurved)
                continue;
            edges_.push_back({i, j});
            clipping::Window box = boxAround(edge.from, endOf(edges_.back()));
            for (const Point& p : edge.between)
                box = {glm::min(box.min, p), glm::max(box.max, p)};
            boxes.push_back(grown(box, near_));
        }
    index_ = BoxIndex(boxes);
}

bool CurvedBorder::divideAtEndsIn(const Objects& objects, const std::stop_token& stop)
{
    Cuts cuts;
    bool isMoved = false;
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        if (object.singleLine() || object.path().straight() || stop.stop_requested())
            return;
        for (const Subpath& path : object.path().subpaths())
            for (std::size_t i = 0; i < path.segments.size(); ++i)
                if (isCurve(path, i))
                    for (const Point& end : {curveOf(path, i).from, path.segments[i].to})
                        isMoved = divideAt(end, cuts) || isMoved;
    });
    if (!cuts.empty())
        divide(cuts);
    makeIndex();
    return isMoved || !cuts.empty();
}

/// Where a corner of the border is the point but for rounding, it becomes the point. Returns
/// whether one does.
bool CurvedBorder::divideAt(const Point& p, Cuts& cuts)
{
    bool isMoved = false;
    std::map<std::size_t, std::pair<std::uint32_t, Where>> nearest; // of each ring
    index_.meeting({p, p}, 0, [&](std::uint32_t number) {
        const Place& place = edges_[number];
        auto& edges = rings_[place.ring].edges;
        for (Edge* edge : {&edges[place.edge], &edges[(place.edge + 1) % edges.size()]})
            if (areSame(edge->from, p)) {
                isMoved = isMoved || edge->from != p;
                edge->from = p;
            }
        const Where where = whereOn(place, p);
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
    return isMoved;
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
            edges.push_back({edge.from, {}, edge.ellipse, true});
            std::size_t next = 0;
            const auto passUntil = [&](double where) {
                for (; next < edge.between.size() && double(next + 1) < where; ++next)
                    edges.back().between.push_back(edge.between[next]);
            };
            for (const auto& [where, p] : places)
                if (!areSame(p, edges.back().from)) {
                    passUntil(where);
                    edges.push_back({p, {}, edge.ellipse, true});
                }
            passUntil(between);
        }
    rings_ = std::move(divided);
}

ClipWindows CurvedBorder::polygons() const
{
    ClipWindows windows = windows_;
    std::map<std::size_t, std::vector<Subpath>> paths;
    for (const Ring& ring : rings_) {
        if (ring.edges.empty()) // of a point
            continue;
        Subpath path{ring.edges.front().from, {}, true};
        for (std::size_t i = 1; i < ring.edges.size(); ++i)
            path.segments.push_back({ring.edges[i].from});
        paths[ring.window].push_back(std::move(path));
    }
    for (const auto& [window, subpaths] : paths) {
        auto& shape = std::get<PathShape>(windows.list[window].shape);
        shape = {Path(subpaths), shape.rule};
    }
    return windows;
}

std::optional<CurvedBorder::Shared>
CurvedBorder::shared(const Place& place, const Bezier& curve,
                     const std::optional<EllipseArc>& ellipse) const
{
    const Edge& edge = edgeAt(place);
    const Point end = endOf(place);
    bool areNear = true, areOnEllipse = ellipse && edge.ellipse;
    double last = 0, first = 0;
    int direction = 0;
    const auto passes = [&](const Point& p, bool begins) {
        const double t = nearestParameter(curve, p), distance = glm::distance(curve.at(t), p);
        areNear = areNear && distance <= near_;
        if (areOnEllipse) {
            const Point there = onEllipse(*ellipse, p), own = onEllipse(*edge.ellipse, p);
            areOnEllipse = glm::distance(own, onEllipse(*ellipse, own)) <= near_
                           && distance <= near_ + 1e-3 * glm::distance(there, ellipse->centre);
        }
        const double at = areSame(p, curve.from) ? 0 : areSame(p, curve.to) ? 1 : t;
        const int way = at > last ? 1 : at < last ? -1 : 0;
        const bool goesOn = begins || (way != 0 && (direction == 0 || way == direction));
        direction = begins ? 0 : way;
        last = at;
        if (begins)
            first = at;
        return (areNear || areOnEllipse) && goesOn;
    };
    if (!passes(edge.from, true)
        || !std::ranges::all_of(edge.between, [&](const Point& p) { return passes(p, false); })
        || !passes(end, false))
        return std::nullopt;
    return direction > 0 ? Shared{first, last, edge.from, end}
                         : Shared{last, first, end, edge.from};
}

std::vector<CurvedBorder::Shared>
CurvedBorder::sharedWith(const Bezier& curve, std::span<const Chord> chords, double tolerance) const
{
    std::vector<std::uint32_t> near;
    for (const Chord& chord : chords)
        index_.meeting(grown(boxAround(chord.segment.a, chord.segment.b), tolerance + near_), 0,
                       [&](std::uint32_t edge) { near.push_back(edge); });
    std::ranges::sort(near);
    near.erase(std::ranges::unique(near).begin(), near.end());
    std::vector<Shared> all;
    if (near.empty())
        return all;
    const auto ellipse = ellipseOf(curve);
    for (const std::uint32_t i : near)
        if (const auto found = shared(edges_[i], curve, ellipse))
            all.push_back(*found);
    std::ranges::sort(all, {}, &Shared::low);
    return all;
}

void CurvedBorder::flattenAlong(const Path& path, double tolerance,
                                std::vector<Chord>& chords) const
{
    const std::size_t begin = chords.size();
    flatten(path, tolerance, chords);
    if (isEmpty() || path.straight())
        return;
    const std::vector<Chord> plain(chords.begin() + std::ptrdiff_t(begin), chords.end());
    chords.resize(begin);
    const std::vector<Subpath> subpaths = path.subpaths();
    std::size_t subpath = 0;
    Point at{};
    for (std::size_t i = 0, end = 0; i < plain.size(); i = end) {
        const auto& [chord, segment, t0, t1] = plain[i];
        const bool begins = segment == 0 && t0 == 0;
        if (i > 0 && begins)
            ++subpath;
        end = i + 1;
        while (end < plain.size() && plain[end].pathSegment == segment && plain[end].t0 != 0)
            ++end;
        const auto own = std::span(plain).subspan(i, end - i);
        if (begins || !areSame(at, chord.a))
            at = chord.a;
        if (isCurve(subpaths[subpath], segment)) {
            flattenAlong(curveOf(subpaths[subpath], segment), own, tolerance, at, chords);
        } else {
            chords.insert(chords.end(), own.begin(), own.end());
            at = own.back().segment.b;
        }
    }
}

/// One curve, with the chords that it has elsewhere; from `at`, and up to there.
void CurvedBorder::flattenAlong(const Bezier& curve, std::span<const Chord> plain, double tolerance,
                                Point& at, std::vector<Chord>& chords) const
{
    double t = 0;
    const auto go = [&](const Point& to, double until) {
        chords.push_back({{at, to}, plain.front().pathSegment, t, until});
        at = to, t = until;
    };
    const auto goPlainly = [&](const Point& to, double until) {
        for (const Chord& chord : plain)
            if (chord.t1 > t && chord.t1 < until)
                go(chord.segment.b, chord.t1);
        if (until > t)
            go(to, until);
    };
    for (const Shared& part : sharedWith(curve, plain, tolerance)) {
        if (part.low == 0 && t == 0) {
            if (areSame(at, part.atLow))
                at = part.atLow;
            else
                go(part.atLow, justAfterStart); // across the border
        } else if (part.low < t || (part.low == t && part.atLow != at)) {
            continue;
        }
        goPlainly(part.atLow, part.low);
        go(part.atHigh, part.high);
    }
    goPlainly(curve.to, 1);
    if (!areSame(at, curve.to))
        go(curve.to, 1);
}

} // namespace app

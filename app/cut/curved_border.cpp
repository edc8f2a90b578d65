// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/curved_border.h"

#include "app/cut/whole_curve.h"
#include "app/document/window_outline.h"

#include <glm/common.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace app {
namespace {

/// Whether a curve is a line, and goes along it in one direction.
bool isStraight(const Bezier& curve)
{
    const Point along = curve.to - curve.from, a = curve.control1 - curve.from,
                b = curve.control2 - curve.from;
    const double length = glm::dot(along, along);
    const auto isBetween = [&](const Point& p) {
        return glm::dot(p, along) >= 0 && glm::dot(p, along) <= length;
    };
    return cross(along, a) == 0 && cross(along, b) == 0 && isBetween(a) && isBetween(b);
}

bool isBorder(const ClipWindow& window, CurvedBorder::Sides sides)
{
    const auto* shape = std::get_if<PathShape>(&window.shape);
    return shape && (sides == CurvedBorder::Sides::Yes || !shape->path.straight());
}

} // namespace

CurvedBorder::CurvedBorder(const ClipWindows& windows, const Page& page, double near, Sides sides)
    : windows_(inEffect(windows)), near_(near > 0 ? near : millimetres / page.millimetresPerUnit())
{
    tolerance_ = std::min(near_ / 2, windowMillimetres / page.millimetresPerUnit());
    std::vector<const Path*> borders;
    for (const ClipWindow& window : windows_.list)
        if (isBorder(window, sides))
            borders.push_back(&std::get<PathShape>(window.shape).path);
    findEllipses(borders);
    for (std::size_t i = 0; i < windows_.list.size(); ++i)
        if (isBorder(windows_.list[i], sides)) {
            withRings_.push_back(i);
            add(std::get<PathShape>(windows_.list[i].shape), i);
        }
    makeIndex();
    if (withRings_.size() > 1)
        divideAtEndsOfWindows();
    addSides();
    if (windows_.list.size() > 1)
        divideWhereWindowsCross();
    if (sides == Sides::No)
        sides_.clear(), sidesAt_ = {};
}

CurvedBorder::CurvedBorder(std::span<const Path> areas, double tolerance, const Page& page,
                           double near)
    : tolerance_(tolerance), near_(near > 0 ? near : millimetres / page.millimetresPerUnit())
{
    std::vector<const Path*> borders;
    for (const Path& area : areas)
        borders.push_back(&area);
    findEllipses(borders);
    for (std::size_t i = 0; i < areas.size(); ++i)
        add({areas[i], FillRule::NonZero}, i);
    makeIndex();
}

CurvedBorder::Sides CurvedBorder::sidesFor(const Objects& objects)
{
    bool hasCurves = false;
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        hasCurves = hasCurves || (!object.singleLine() && !object.path().straight());
    });
    return hasCurves ? Sides::Yes : Sides::No;
}

/// The straight edges of all windows.
void CurvedBorder::addSides()
{
    for (const ClipWindow& window : windows_.list) {
        const auto* shape = std::get_if<PathShape>(&window.shape);
        if (shape && !shape->path.straight())
            continue;
        for (const auto& ring : outlineOf(window.shape, tolerance_).rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                sides_.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
    for (const Ring& ring : rings_)
        for (std::size_t i = 0; i < ring.edges.size(); ++i)
            if (!ring.edges[i].isCurved())
                sides_.push_back(
                    {ring.edges[i].from, ring.edges[(i + 1) % ring.edges.size()].from});
    std::vector<clipping::Window> boxes;
    for (const clipping::Segment& side : sides_)
        boxes.push_back(around(side, 0));
    sidesAt_ = BoxIndex(boxes);
}

void CurvedBorder::add(const PathShape& shape, std::size_t window)
{
    for (const Subpath& path : shape.path.subpaths())
        add(path, window);
}

void CurvedBorder::add(const Subpath& path, std::size_t window)
{
    std::vector<Chord> chords;
    flattenTruly(path, tolerance_, chords);
    const bool hasCurves = std::ranges::any_of(path.segments, &PathSegment::curved);
    const std::uint32_t line = hasCurves ? Edge::straight : Edge::side;
    Ring& ring = rings_.emplace_back(Ring{window});
    std::optional<std::size_t> segment; // of the last source
    for (const Chord& chord : chords) {
        Edge edge{chord.segment.a, 0, 0, line};
        if (isCurve(path, chord.pathSegment) && isStraight(curveOf(path, chord.pathSegment))) {
            edge.source = Edge::side;
        } else if (isCurve(path, chord.pathSegment)) {
            if (std::exchange(segment, chord.pathSegment) != chord.pathSegment)
                sources_.push_back(curveAt(path, chord.pathSegment));
            edge = {chord.segment.a, chord.t0, chord.t1, std::uint32_t(sources_.size() - 1),
                    chord.t0 == 0};
        }
        if (chord.segment.a != chord.segment.b)
            ring.edges.push_back(edge);
    }
    if (const Point end = chords.back().segment.b; end != chords.front().segment.a)
        ring.edges.push_back({end, 0, 0, line}); // an open path counts as closed
}

void CurvedBorder::findEllipses(std::span<const Path* const> borders)
{
    std::vector<clipping::Window> boxes;
    for (const Path* border : borders)
        for (const Subpath& path : border->subpaths())
            for (std::size_t i = 0; i < path.segments.size(); ++i) {
                const auto drawn = isCurve(path, i) ? ellipseAt(path, i) : std::nullopt;
                if (!drawn || !drawn->isCertain)
                    continue;
                const auto& [centre, a, b, angle, sweep] = drawn->ellipse;
                const Point reach = Point(std::hypot(a.x, b.x), std::hypot(a.y, b.y)) + near_;
                boxes.push_back({centre - reach, centre + reach});
                ellipses_.push_back(drawn->ellipse);
            }
    ellipsesAt_ = BoxIndex(boxes);
}

TrueCurve CurvedBorder::curveAt(const Subpath& path, std::size_t segment) const
{
    return {path, segment, [&](const EllipseArc& arc) {
                const std::array places{arc.at(arc.angle), arc.at(arc.angle + arc.sweep / 2),
                                        arc.at(arc.angle + arc.sweep)};
                bool isKnown = false;
                ellipsesAt_.meeting({places[0], places[0]}, 0, [&](std::uint32_t i) {
                    isKnown = isKnown || std::ranges::all_of(places, [&](const Point& p) {
                                  return glm::distance(onEllipse(ellipses_[i], p), p) <= near_;
                              });
                });
                return isKnown;
            }};
}

bool CurvedBorder::areSame(const std::optional<EllipseArc>& a,
                           const std::optional<EllipseArc>& b) const
{
    if (!a || !b || !areSame(a->centre, b->centre))
        return false;
    const Point &x = b->axis1, &y = b->axis2;
    const std::array some{x, y, (x + y) * std::numbers::sqrt2 * 0.5};
    return std::ranges::all_of(some, [&](const Point& way) {
        return areSame(onEllipse(*a, b->centre + way), b->centre + way);
    });
}

// Each part of the edge is 64 times nearer to the curve than the edge.
std::array<Point, 7> CurvedBorder::between(const Place& place) const
{
    const Edge& edge = edgeAt(place);
    std::array<Point, 7> places;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double share = (double(i) + 1) / double(places.size() + 1);
        places[i] = edge.isCurved() ? sourceOf(edge).at(edge.t0 + (edge.t1 - edge.t0) * share)
                                    : edge.from + (endOf(place) - edge.from) * share;
    }
    return places;
}

void CurvedBorder::makeIndex()
{
    edges_.clear();
    edgesOf_.assign(sources_.size(), {0, 0});
    std::vector<clipping::Window> boxes, starts, curves;
    for (std::size_t i = 0; i < rings_.size(); ++i)
        for (std::size_t j = 0; j < rings_[i].edges.size(); ++j) {
            const Edge& edge = rings_[i].edges[j];
            if (edge.isStraight())
                continue;
            if (edge.isCurved()) {
                auto& [first, end] = edgesOf_[edge.source];
                first = end == 0 ? std::uint32_t(edges_.size()) : first;
                end = std::uint32_t(edges_.size()) + 1;
            }
            edges_.push_back({i, j});
            const Point& end = endOf(edges_.back());
            clipping::Window box{glm::min(edge.from, end), glm::max(edge.from, end)};
            for (const Point& p : between(edges_.back()))
                box = {glm::min(box.min, p), glm::max(box.max, p)};
            boxes.push_back({box.min - near_, box.max + near_});
            starts.push_back({edge.from, edge.from});
        }
    for (const TrueCurve& source : sources_)
        curves.push_back(source.box());
    index_ = BoxIndex(boxes);
    curves_ = BoxIndex(curves);
    starts_ = BoxIndex(starts);
}

/// A window's polygon, with the edges of the windows before it where the border is the same.
std::vector<Subpath> CurvedBorder::alongOthers(const Path& border) const
{
    std::vector<Chord> chords;
    flattenAlong(border, tolerance_, chords);
    std::vector<Subpath> polygons;
    for (const auto& [chord, segment, t0, t1] : chords)
        if (segment == 0 && t0 == 0)
            polygons.push_back({chord.a, {{chord.b}}, true});
        else
            polygons.back().segments.push_back({chord.b});
    return polygons;
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
    for (const std::size_t i : withRings_) {
        auto& shape = std::get<PathShape>(windows.list[i].shape);
        shape = {Path(i == withRings_.front() ? paths[i] : alongOthers(shape.path)), shape.rule};
    }
    return windows;
}

} // namespace app

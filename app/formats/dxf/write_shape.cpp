// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/write_shape.h"

#include "app/document/flatten.h"
#include "app/formats/dxf/write_arcs.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace app::dxf::writing {
namespace {

/// An arc with positive angles in a plane whose y points up.
Shape shapeOfArc(const EllipseArc& arc)
{
    constexpr double full = 2 * std::numbers::pi;
    const double from = arc.sweep < 0 ? arc.angle + arc.sweep : arc.angle;
    const double sweep = std::abs(arc.sweep);
    const bool up = cross(arc.axis1, arc.axis2) > 0;
    if (isCircle(arc)) {
        const double turn = std::atan2(arc.axis1.y, arc.axis1.x);
        const double first = up ? turn + from : turn - from - sweep;
        return ArcShape{arc.centre, glm::length(arc.axis1), std::fmod(first + 2 * full, full),
                        sweep};
    }
    // Where the point is farthest from the centre, the slope is at right angles to the way there.
    const Point &a = arc.axis1, &b = arc.axis2;
    double top = 0.5 * std::atan2(2 * glm::dot(a, b), glm::dot(a, a) - glm::dot(b, b));
    const Point major = a * std::cos(top) + b * std::sin(top);
    const Point minor = b * std::cos(top) - a * std::sin(top);
    const double first = up ? from - top : top - from - sweep;
    return EllipseShape{arc.centre, major, std::min(1.0, glm::length(minor) / glm::length(major)),
                        std::fmod(first + 2 * full, full), sweep};
}

/// The vertices up to the end of the path, with the lines of flattened curves.
class Vertices {
public:
    explicit Vertices(const Point& start) : all_{{start}} {}

    void add(const Point& to, double bulge = 0)
    {
        if (to == all_.back().at)
            return;
        all_.back().bulge = bulge;
        all_.push_back({to});
    }

    Shape take(bool closed)
    {
        if (closed && all_.size() > 2 && all_.back().at == all_.front().at)
            all_.pop_back(); // the arc or line before it goes to the first one
        if (all_.size() == 1)
            return PointShape{all_.front().at};
        if (all_.size() == 2 && all_.front().bulge == 0 && all_.back().bulge == 0)
            return LineShape{all_.front().at, all_.back().at};
        return PolylineShape{std::move(all_), closed};
    }

private:
    std::vector<Vertex> all_;
};

Shape splineOf(const Subpath& path)
{
    SplineShape spline{{path.start}};
    const auto add = [&](const PathSegment& segment) {
        const Point from = spline.controls.back(), way = segment.to - from;
        if (!segment.curved && way == Point{0, 0})
            return;
        spline.controls.push_back(segment.curved ? segment.control1 : from + way / 3.0);
        spline.controls.push_back(segment.curved ? segment.control2 : segment.to - way / 3.0);
        spline.controls.push_back(segment.to);
    };
    for (const PathSegment& segment : path.segments)
        add(segment);
    if (path.closed)
        add({path.start});
    return spline;
}

} // namespace

bool hasOnlyArcs(const Subpath& path)
{
    return std::ranges::all_of(bulgesOf(path), [](const auto& bulge) { return bulge.has_value(); });
}

Shape shapeOf(const Subpath& path, Curves curves, double tolerance)
{
    const bool straight = std::ranges::none_of(path.segments, &PathSegment::curved);
    if (const auto arc = straight ? std::nullopt : singleArcOf(path);
        arc && (curves == Curves::All || isCircle(*arc)))
        return shapeOfArc(*arc);
    const auto bulges = bulgesOf(path);
    const bool onlyArcs = std::ranges::all_of(bulges, [](const auto& b) { return b.has_value(); });
    if (!onlyArcs && curves == Curves::All)
        return splineOf(path);
    Vertices vertices(path.start);
    std::vector<Chord> chords;
    Point at = path.start;
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
        const PathSegment& segment = path.segments[i];
        chords.clear();
        if (!bulges[i])
            flatten(at, segment, i, tolerance, chords);
        for (const Chord& chord : chords)
            vertices.add(chord.segment.b);
        vertices.add(segment.to, bulges[i].value_or(0));
        at = segment.to;
    }
    return vertices.take(path.closed);
}

} // namespace app::dxf::writing

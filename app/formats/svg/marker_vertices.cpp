// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/marker_vertices.h"

#include <algorithm>
#include <cmath>

namespace app::svg {
namespace {

using Direction = std::optional<Point>; // of length 1; empty: none

Direction directionFrom(const Point& a, std::initializer_list<Point> others)
{
    for (const Point& b : others)
        if (const Point step = b - a; step != Point{})
            return step / std::hypot(step.x, step.y);
    return std::nullopt;
}

/// The directions in which a segment begins and ends; empty for one without length.
struct SegmentEnds {
    Direction begin, end;
};

SegmentEnds endsOf(const Point& from, const PathSegment& s)
{
    if (!s.curved)
        return {directionFrom(from, {s.to}), directionFrom(from, {s.to})};
    Direction end = directionFrom(s.to, {s.control2, s.control1, from});
    if (end)
        end = -*end;
    return {directionFrom(from, {s.control1, s.control2, s.to}), end};
}

std::vector<SegmentEnds> endsOf(const Subpath& path)
{
    std::vector<SegmentEnds> ends;
    Point from = path.start;
    for (const PathSegment& segment : path.segments) {
        ends.push_back(endsOf(from, segment));
        from = segment.to;
    }
    if (path.closed)
        ends.push_back(endsOf(from, {path.start}));
    return ends;
}

double angleBetween(const Direction& in, const Direction& out)
{
    Point sum = in.value_or(Point{}) + out.value_or(Point{});
    if (std::hypot(sum.x, sum.y) < 1e-9) // it turns back
        sum = in ? *in : Point{1, 0};
    return std::atan2(sum.y, sum.x);
}

// A segment without length has the direction of the one before it, or else after it.
void fillGaps(std::vector<SegmentEnds>& ends)
{
    Direction last;
    for (SegmentEnds& each : ends) {
        if (!each.begin)
            each = {last, last};
        last = each.end;
    }
    last.reset();
    for (auto each = ends.rbegin(); each != ends.rend(); ++each) {
        if (!each->begin)
            *each = {last, last};
        last = each->begin;
    }
}

void addVertices(const Subpath& path, std::vector<MarkerVertex>& vertices)
{
    auto ends = endsOf(path);
    fillGaps(ends);
    const auto at = [&](std::size_t i) {
        return i == 0 || i > path.segments.size() ? path.start : path.segments[i - 1].to;
    };
    const Direction around = path.closed && !ends.empty() ? ends.back().end : std::nullopt;
    for (std::size_t i = 0; i <= ends.size(); ++i) {
        const Direction in = i > 0 ? ends[i - 1].end : around;
        const bool closes = i == ends.size() && path.closed && !ends.empty();
        const Direction out = i < ends.size() ? ends[i].begin
                              : closes        ? ends.front().begin
                                              : std::nullopt;
        vertices.push_back({at(i), MarkerVertex::Kind::Mid, angleBetween(in, out)});
    }
}

} // namespace

std::vector<MarkerVertex> markerVertices(const Outline& outline)
{
    std::vector<MarkerVertex> vertices;
    auto joint = outline.joints.begin();
    for (std::size_t i = 0; i < outline.paths.size(); ++i) {
        const std::size_t first = vertices.size();
        addVertices(outline.paths[i], vertices);
        std::size_t removed = 0; // where arcs are made of several curves
        for (; joint != outline.joints.end() && joint->path == i; ++joint, ++removed)
            vertices.erase(vertices.begin() + std::ptrdiff_t(first + joint->segment + 1 - removed));
    }
    if (vertices.empty())
        return vertices;
    vertices.front().kind = MarkerVertex::Kind::Start;
    if (vertices.size() > 1)
        vertices.back().kind = MarkerVertex::Kind::End;
    return vertices;
}

} // namespace app::svg

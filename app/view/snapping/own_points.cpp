// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/own_points.h"

#include "app/document/bezier.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace app {
namespace {

constexpr std::size_t mostLooked = 4000;

void addLinePoints(const clipping::Segment& line, std::vector<Point>& points)
{
    if (points.empty() || points.back() != line.a)
        points.push_back(line.a);
    points.push_back(line.a + (line.b - line.a) * 0.5);
    points.push_back(line.b);
}

void addPath(const Path& path, std::vector<Point>& points)
{
    for (const Subpath& subpath : path.subpaths()) {
        Point from = subpath.start;
        points.push_back(from);
        for (const PathSegment& s : subpath.segments) {
            if (points.size() >= mostLooked)
                return;
            points.push_back(s.curved ? Bezier{from, s.control1, s.control2, s.to}.at(0.5)
                                      : from + (s.to - from) * 0.5);
            points.push_back(s.to);
            from = s.to;
        }
    }
}

std::vector<Point> cornersAndCentre(const clipping::Window& box)
{
    const auto& [min, max] = box;
    return {min, {max.x, min.y}, max, {min.x, max.y}, min + (max - min) * 0.5};
}

} // namespace

OwnPoints ownPointsOf(const clipping::Window& box)
{
    OwnPoints own{cornersAndCentre(box), box};
    const Point middle = own.points.back();
    own.points.insert(own.points.end(), {{middle.x, box.min.y},
                                         {box.max.x, middle.y},
                                         {middle.x, box.max.y},
                                         {box.min.x, middle.y}});
    return own;
}

OwnPoints ownPointsOf(const Document& document, const SceneLines& lines,
                      const ObjectRanges& objects, const clipping::Window& bounds,
                      const Point& grabbed)
{
    std::vector<Point> points;
    for (const std::size_t object : objects) {
        if (points.size() >= mostLooked)
            break;
        const Path path = document.objects()[object].path();
        const std::size_t end = lines.firstLineOf(object + 1);
        if (!path.straight())
            addPath(path, points);
        else
            for (std::size_t i = lines.firstLineOf(object); i < end && points.size() < mostLooked;
                 ++i)
                addLinePoints(lines[i], points);
    }
    OwnPoints own{cornersAndCentre(bounds), bounds};
    const std::size_t room = OwnPoints::most - own.points.size();
    if (points.size() > room) {
        std::ranges::nth_element(points, points.begin() + std::ptrdiff_t(room), {},
                                 [&](const Point& p) { return glm::distance(p, grabbed); });
        points.resize(room);
    }
    own.points.insert(own.points.end(), points.begin(), points.end());
    return own;
}

} // namespace app

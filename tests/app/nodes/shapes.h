// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_path.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <vector>

// Paths for the tests of nodes, and how far two shapes are apart.

inline app::NodeSubpath nodesOf(const app::Subpath& subpath)
{
    return app::nodesOf(std::span(&subpath, 1)).front();
}
inline app::NodeSubpath polyline(const std::vector<app::Point>& corners, bool closed = false)
{
    app::Subpath path{corners.front(), {}, closed};
    for (std::size_t i = 1; i < corners.size(); ++i)
        path.segments.push_back({corners[i]});
    return nodesOf(path);
}
/// Two curves that meet smoothly in (60, 0).
inline app::Subpath wave()
{
    return {{0, 0},
            {{{60, 0}, {20, -40}, {40, -30}, true}, {{120, 10}, {70, 15}, {100, 60}, true}},
            false};
}
/// A circle around (0, 0) of four curves.
inline app::Subpath circle(double r)
{
    const double k = 0.5522847498307936 * r;
    return {{r, 0},
            {{{0, r}, {r, k}, {k, r}, true},
             {{-r, 0}, {-k, r}, {-r, k}, true},
             {{0, -r}, {-r, -k}, {-k, -r}, true},
             {{r, 0}, {k, -r}, {r, -k}, true}},
            true};
}

inline std::vector<app::Point> pointsOn(const app::NodeSubpath& subpath, int ofSegment = 64)
{
    std::vector<app::Point> points;
    for (std::size_t i = 0; i < subpath.segmentCount(); ++i)
        for (int k = 0; k <= ofSegment; ++k)
            points.push_back(subpath.segment(i).at(double(k) / ofSegment));
    return points;
}
inline double distanceTo(const app::Point& p, const app::Point& a, const app::Point& b)
{
    const double square = glm::dot(b - a, b - a);
    const double t = square > 0 ? std::clamp(glm::dot(p - a, b - a) / square, 0.0, 1.0) : 0;
    return glm::distance(p, a + (b - a) * t);
}
/// The largest distance of a point of one shape from the other shape.
inline double apart(const app::NodeSubpath& one, const app::NodeSubpath& other)
{
    const auto points = pointsOn(other, 256);
    double most = 0;
    for (const app::Point& p : pointsOn(one)) {
        double least = INFINITY;
        for (std::size_t i = 1; i < points.size(); ++i)
            least = std::min(least, distanceTo(p, points[i - 1], points[i]));
        most = std::max(most, least);
    }
    return most;
}

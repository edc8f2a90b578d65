// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/region/region.h"

#include <cmath>
#include <numbers>

#include "tests/clipping/scenes.h"

// Areas to be clipped, and to clip at.

inline clipping::Area circle(int corners, double radius)
{
    clipping::Area area;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        area.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return area;
}

/// A ragged island that does not cross itself, seen from its middle: other libraries refuse one
/// that does.
inline clipping::Area simpleCoastLine(std::size_t edges)
{
    RandomNumbers random(8);
    std::vector<double> radii(6, 450);
    for (double most = 120; radii.size() < edges; most *= 0.55) {
        std::vector<double> finer;
        for (std::size_t i = 0; i < radii.size(); ++i) {
            const double next = radii[(i + 1) % radii.size()];
            finer.push_back(radii[i]);
            finer.push_back((radii[i] + next) / 2 + random.uniform(-most, most));
        }
        radii = std::move(finer);
    }
    clipping::Area area;
    for (std::size_t i = 0; i < edges; ++i) {
        const double angle = 2 * std::numbers::pi * double(i) / double(edges);
        const double radius = radii[i * radii.size() / edges];
        area.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return area;
}

/// A ragged island: each side of a hexagon is divided at its displaced middle, again and again.
inline clipping::Area coastLine(std::size_t edges)
{
    RandomNumbers random(7);
    auto points = circle(6, 500).points;
    while (points.size() < edges) {
        std::vector<glm::dvec2> finer;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto &p = points[i], &q = points[(i + 1) % points.size()];
            const glm::dvec2 along = q - p;
            finer.push_back(p);
            if (points.size() + i < edges)
                finer.push_back(p + 0.5 * along
                                + random.uniform(-0.3, 0.3) * glm::dvec2(-along.y, along.x));
        }
        points = std::move(finer);
    }
    return {std::move(points)};
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/geojson/polygons.h"

#include "clipping/geometry.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app::geojson {
namespace {

double signedArea(const Ring& ring)
{
    double area = 0;
    for (std::size_t i = 1; i < ring.size(); ++i)
        area += cross(ring[i - 1] - ring.front(), ring[i] - ring.front()) / 2;
    return area;
}

bool isInside(const Point& p, const Ring& ring)
{
    bool inside = false;
    for (std::size_t i = 1; i < ring.size(); ++i) {
        const Point &a = ring[i - 1], &b = ring[i];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

struct SizedRing {
    Ring ring;
    double area; ///< > 0
    clipping::Window box;
    std::size_t depth = 0;   ///< how many rings surround it
    std::size_t polygon = 0; ///< of an outer ring

    explicit SizedRing(Ring points)
        : ring(std::move(points)), area(signedArea(ring)), box{ring.front(), ring.front()}
    {
        if (area < 0)
            std::ranges::reverse(ring);
        area = std::abs(area);
        for (const Point& p : ring)
            box = {glm::min(box.min, p), glm::max(box.max, p)};
    }

    // A vertex may be on the other ring, if they touch: the majority of some points counts.
    bool surrounds(const SizedRing& other) const
    {
        if (!(box.min.x <= other.box.min.x && box.min.y <= other.box.min.y
              && box.max.x >= other.box.max.x && box.max.y >= other.box.max.y))
            return false;
        int balance = 0;
        for (std::size_t i = 1; i < other.ring.size() && std::abs(balance) < 3; ++i)
            balance += isInside((other.ring[i - 1] + other.ring[i]) * 0.5, ring) ? 1 : -1;
        return balance > 0;
    }
};

} // namespace

std::vector<Polygon> polygonsOf(std::vector<Ring> rings)
{
    std::vector<SizedRing> sized;
    for (Ring& ring : rings)
        if (ring.size() > 3)
            sized.emplace_back(std::move(ring));
    std::erase_if(sized, [](const SizedRing& ring) { return !(ring.area > 0); });
    std::ranges::stable_sort(sized, std::ranges::greater(), &SizedRing::area);
    std::vector<Polygon> polygons;
    for (std::size_t i = 0; i < sized.size(); ++i) {
        std::size_t around = 0; // the smallest ring around it that is larger
        for (std::size_t j = 0; j < i; ++j)
            if (sized[j].surrounds(sized[i])) {
                ++sized[i].depth;
                around = j;
            }
        if (sized[i].depth % 2 == 0) {
            sized[i].polygon = polygons.size();
            polygons.push_back({sized[i].ring});
        } else {
            std::ranges::reverse(sized[i].ring);
            sized[i].polygon = sized[around].polygon;
            polygons[sized[i].polygon].push_back(sized[i].ring);
        }
    }
    return polygons;
}

} // namespace app::geojson

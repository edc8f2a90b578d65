// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/underlay.h"

#include "app/document/document.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

double twiceArea(const std::vector<Point>& polygon)
{
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    return sum;
}

/// The part of a polygon on one side of the line from a to b: that of positive cross products.
std::vector<Point> partBeside(const std::vector<Point>& polygon, const Point& a, const Point& b)
{
    std::vector<Point> part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double sideOfP = cross(b - a, p - a), sideOfQ = cross(b - a, q - a);
        if (sideOfP >= 0)
            part.push_back(p);
        if ((sideOfP < 0) == (sideOfQ < 0) || sideOfP == 0 || sideOfQ == 0)
            continue;
        Point meets = p + (q - p) * (sideOfP / (sideOfP - sideOfQ));
        for (const int axis : {0, 1}) // on an edge along an axis bit for bit
            if (a[axis] == b[axis])
                meets[axis] = a[axis];
            else if (p[axis] == q[axis])
                meets[axis] = p[axis];
        part.push_back(meets);
    }
    return part;
}

} // namespace

std::vector<Point> cornersOfBox(const clipping::Window& w)
{
    return {w.min, {w.max.x, w.min.y}, w.max, {w.min.x, w.max.y}};
}

std::vector<Point> outlineOf(const Underlay& underlay)
{
    if (!underlay.clip.empty())
        return underlay.clip;
    std::vector<Point> corners =
        cornersOfBox({{0, 0}, {double(underlay.file->width), double(underlay.file->height)}});
    for (Point& corner : corners)
        corner = underlay.place(corner);
    return corners;
}

std::vector<Point> commonArea(std::vector<Point> polygon, const std::vector<Point>& other)
{
    const bool turns = twiceArea(other) < 0;
    for (std::size_t i = 0; i < other.size() && !polygon.empty(); ++i) {
        const Point &a = other[i], &b = other[(i + 1) % other.size()];
        if (a != b)
            polygon = turns ? partBeside(polygon, b, a) : partBeside(polygon, a, b);
    }
    const bool hasArea = polygon.size() > 2 && std::abs(twiceArea(polygon)) > 0;
    return hasArea ? polygon : std::vector<Point>();
}

bool cut(Underlay& underlay, const std::vector<Point>& inside)
{
    const std::vector<Point> before = outlineOf(underlay);
    std::vector<Point> left = commonArea(before, inside);
    if (left.empty())
        return false;
    if (left != before)
        underlay.clip = std::move(left);
    return true;
}

std::vector<SeenUnderlay> seenUnderlays(const Document& document)
{
    const Containers& tree = document.containers();
    std::vector<SeenUnderlay> seen;
    for (const ContainerId id : tree.underlaid())
        if (tree.shown(id))
            seen.push_back({tree.rangeOf(id).first, tree[id].underlay});
    return seen;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/label_places.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

QRectF around(const QPointF& middle, const QSizeF& size)
{
    return {middle.x() - size.width() / 2, middle.y() - size.height() / 2, size.width(),
            size.height()};
}

double crossProduct(const QPointF& u, const QPointF& v) { return u.x() * v.y() - u.y() * v.x(); }

/// For polygons of either orientation.
bool contains(const QPolygonF& convex, const QPointF& p)
{
    bool left = false, right = false;
    for (qsizetype i = 0; i < convex.size(); ++i) {
        const QPointF &a = convex[i], &b = convex[(i + 1) % convex.size()];
        const double side = crossProduct(b - a, p - a);
        left = left || side > 0;
        right = right || side < 0;
    }
    return !(left && right);
}

bool contains(const QPolygonF& convex, const QRectF& r)
{
    return contains(convex, r.topLeft()) && contains(convex, r.topRight())
           && contains(convex, r.bottomLeft()) && contains(convex, r.bottomRight());
}

/// The centre of mass; for a polygon without area the mean of its corners.
QPointF centroid(const QPolygonF& convex)
{
    QPointF sum, mean;
    double area = 0;
    for (qsizetype i = 0; i < convex.size(); ++i)
        mean += convex[i] / double(convex.size());
    for (qsizetype i = 2; i < convex.size(); ++i) {
        const double part = crossProduct(convex[i - 1] - convex[0], convex[i] - convex[0]);
        area += part;
        sum += part * (convex[0] + convex[i - 1] + convex[i]) / 3;
    }
    return area == 0 ? mean : sum / area;
}

} // namespace

std::optional<QRectF> LabelPlaces::first(std::span<const QRectF> wanted)
{
    const auto hidesAnyOf = [](const QRectF& place, const std::vector<QRectF>& others) {
        return std::ranges::any_of(others,
                                   [&](const QRectF& other) { return other.intersects(place); });
    };
    std::optional<QRectF> best;
    for (const QRectF& place : wanted) {
        if (!room_.contains(place) || hidesAnyOf(place, taken_))
            continue;
        const bool clear = !hidesAnyOf(place, avoided_);
        if (clear || !best)
            best = place;
        if (clear)
            break;
    }
    if (best)
        taken_.push_back(*best);
    return best;
}

std::vector<QRectF> boxesOfShortLines(std::span<const QLineF> lines, const QRectF& room)
{
    constexpr double longest = 120, margin = 2; // pixels
    constexpr std::size_t most = 2000;
    std::vector<QRectF> boxes;
    for (const QLineF& line : lines) {
        if (line.length() > longest || !room.contains(line.p1()) || !room.contains(line.p2()))
            continue;
        if (boxes.size() == most)
            return {};
        boxes.push_back(
            QRectF(line.p1(), line.p2()).normalized().adjusted(-margin, -margin, margin, margin));
    }
    return boxes;
}

std::vector<QRectF> placesBeside(const QPointF& point, const QSizeF& size, double gap)
{
    const double w = size.width() / 2 + gap, h = size.height() / 2 + gap;
    std::vector<QRectF> places;
    for (const double far : {1.0, 2.2})
        for (const auto& [x, y] : {std::pair{1.0, 0.0},
                                   {-1.0, 0.0},
                                   {0.0, -1.0},
                                   {0.0, 1.0},
                                   {1.0, -1.0},
                                   {1.0, 1.0},
                                   {-1.0, -1.0},
                                   {-1.0, 1.0}})
            places.push_back(around(point + QPointF(x * w, y * h * far), size));
    return places;
}

std::vector<QRectF> placesInside(const QPolygonF& convex, const QSizeF& size)
{
    std::vector<QRectF> places;
    if (convex.size() < 3)
        return places;
    const QPointF middle = centroid(convex);
    const auto add = [&](const QPointF& at) {
        if (const QRectF place = around(at, size); contains(convex, place))
            places.push_back(place);
    };
    add(middle);
    for (const double share : {0.25, 0.5, 0.7})
        for (const QPointF& corner : convex)
            add(middle + share * (corner - middle));
    return places;
}

std::vector<QRectF> placesAlong(const QLineF& line, const QSizeF& size, double gap)
{
    std::vector<QRectF> places;
    const double length = line.length();
    if (length == 0)
        return places;
    const QPointF along = (line.p2() - line.p1()) / length, across(-along.y(), along.x());
    const double reach =
        std::abs(along.x()) * size.width() / 2 + std::abs(along.y()) * size.height() / 2;
    const double aside =
        std::abs(across.x()) * size.width() / 2 + std::abs(across.y()) * size.height() / 2 + gap;
    for (const double in : {reach + gap, length - reach - gap, length / 4, length * 3 / 4})
        for (const double side : {1.0, -1.0})
            places.push_back(around(line.p1() + in * along + side * aside * across, size));
    return places;
}

std::vector<QLineF> hatching(const QPolygonF& convex, double spacing)
{
    std::vector<QLineF> lines;
    if (convex.size() < 3)
        return lines;
    const auto sum = [](const QPointF& p) { return p.x() + p.y(); };
    const auto [low, high] = std::ranges::minmax_element(convex, {}, sum);
    constexpr double most = 1e6; // pixels from the origin; larger than any screen
    const double first = std::ceil(sum(*low) / spacing), last = std::ceil(sum(*high) / spacing);
    if (!(first >= -most && last <= most))
        return lines;
    for (int line = int(first); line < int(last); ++line) {
        const double at = line * spacing;
        std::array<QPointF, 2> ends;
        std::size_t found = 0;
        for (qsizetype i = 0; i < convex.size() && found < 2; ++i) {
            const QPointF &a = convex[i], &b = convex[(i + 1) % convex.size()];
            if ((sum(a) < at) != (sum(b) < at))
                ends[found++] = a + (at - sum(a)) / (sum(b) - sum(a)) * (b - a);
        }
        if (found == 2)
            lines.push_back({ends[0], ends[1]});
    }
    return lines;
}

} // namespace app

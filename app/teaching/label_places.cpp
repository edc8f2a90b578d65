// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/label_places.h"

#include "clipping/algorithm.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

bool crosses(const QLineF& line, const QRectF& box)
{
    const clipping::Segment segment{{line.x1(), line.y1()}, {line.x2(), line.y2()}};
    const clipping::Window window{{box.left(), box.top()}, {box.right(), box.bottom()}};
    return clipping::exactAlgorithm().corrected.clip(segment, window).has_value();
}

bool isFree(const QRectF& place, const LabelObstacles& obstacles)
{
    return obstacles.inside.contains(place)
           && std::ranges::none_of(obstacles.boxes,
                                   [&](const QRectF& box) { return box.intersects(place); })
           && !covers(place, obstacles.lines);
}

/// The penalty of a free place: what it covers, and its rank in the list.
double badness(const QRectF& place, std::size_t rank, const LabelObstacles& obstacles)
{
    const auto covered = std::ranges::count_if(
        obstacles.avoided, [&](const QLineF& line) { return crosses(line, place); });
    return 16 * double(covered) + double(rank);
}

} // namespace

bool covers(const QRectF& box, std::span<const QLineF> lines)
{
    return std::ranges::any_of(lines, [&](const QLineF& line) { return crosses(line, box); });
}

std::optional<QRectF> freePlace(std::span<const QRectF> places, const LabelObstacles& obstacles)
{
    std::optional<QRectF> best;
    double least = 0;
    for (std::size_t i = 0; i < places.size() && (!best || double(i) < least); ++i) {
        if (!isFree(places[i], obstacles))
            continue;
        const double bad = badness(places[i], i, obstacles);
        if (!best || bad < least)
            best = places[i], least = bad;
    }
    return best;
}

std::vector<QRectF> placesAround(const QPointF& mark, double radius, const QSizeF& label)
{
    // The position of the label's middle, in half sizes of the label and gaps from the mark.
    static constexpr std::array<std::array<double, 2>, 12> ways{{{1, 1},
                                                                 {1, -1},
                                                                 {-1, 1},
                                                                 {-1, -1},
                                                                 {1, 0},
                                                                 {-1, 0},
                                                                 {0, 1},
                                                                 {0, -1},
                                                                 {0.5, 1},
                                                                 {0.5, -1},
                                                                 {-0.5, 1},
                                                                 {-0.5, -1}}};
    std::vector<QRectF> places;
    for (const double gap : {1.2, 2.4, 4.5, 8.0})
        for (const auto& [x, y] : ways) {
            const QPointF middle = mark
                                   + QPointF(x * (label.width() / 2 + gap * radius),
                                             y * (label.height() / 2 + gap * radius));
            places.emplace_back(middle - QPointF(label.width() / 2, label.height() / 2), label);
        }
    return places;
}

std::vector<QRectF> placesWithin(const QRectF& area, const QPointF& near, const QSizeF& label)
{
    constexpr int steps = 24;
    std::vector<QRectF> places;
    const double width = area.width() - label.width(), height = area.height() - label.height();
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j)
            places.emplace_back(area.topLeft() + QPointF(width * i / steps, height * j / steps),
                                label);
    const auto distance = [&](const QRectF& place) {
        return QLineF(near, place.center()).length();
    };
    std::ranges::stable_sort(places, {}, distance);
    return places;
}

} // namespace app

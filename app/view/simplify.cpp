// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/simplify.h"

#include "app/view/picking.h"

namespace app {
namespace {

/// The point between `first` and `last` that is farthest from the line between them, if farther
/// than `least`; otherwise `first`.
std::size_t farthestBetween(std::span<const Point> polyline, std::size_t first, std::size_t last,
                            double least)
{
    std::size_t farthest = first;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double d = distance(polyline[i], {polyline[first], polyline[last]});
        if (d > least) {
            least = d;
            farthest = i;
        }
    }
    return farthest;
}

} // namespace

std::vector<Point> simplified(std::span<const Point> polyline, double tolerance)
{
    if (polyline.size() < 3)
        return {polyline.begin(), polyline.end()};
    std::vector<bool> kept(polyline.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> spans{{0, polyline.size() - 1}};
    while (!spans.empty()) {
        const auto [first, last] = spans.back();
        spans.pop_back();
        const std::size_t farthest = farthestBetween(polyline, first, last, tolerance);
        if (farthest == first)
            continue;
        kept[farthest] = true;
        spans.push_back({first, farthest});
        spans.push_back({farthest, last});
    }
    std::vector<Point> few;
    for (std::size_t i = 0; i < polyline.size(); ++i)
        if (kept[i])
            few.push_back(polyline[i]);
    return few;
}

} // namespace app

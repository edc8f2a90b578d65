// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/nearest_points.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace app {
namespace {

std::size_t middle(std::size_t first, std::size_t end) { return first + (end - first) / 2; }

} // namespace

struct NearestPoints::Search {
    Point from;
    std::size_t but, other; ///< these do not count
    double most;
    std::size_t found = std::numeric_limits<std::size_t>::max();
};

NearestPoints::NearestPoints(std::vector<Point> points)
    : points_(std::move(points)), order_(points_.size()), place_(points_.size()),
      left_(points_.size()), axis_(points_.size()), gone_(points_.size())
{
    std::iota(order_.begin(), order_.end(), 0U);
    divide(0, order_.size());
    for (std::size_t at = 0; at < order_.size(); ++at)
        place_[order_[at]] = std::uint32_t(at);
}

void NearestPoints::divide(std::size_t first, std::size_t end)
{
    if (first == end)
        return;
    Point least = points_[order_[first]], most = least;
    for (std::size_t at = first + 1; at < end; ++at) {
        least = glm::min(least, points_[order_[at]]);
        most = glm::max(most, points_[order_[at]]);
    }
    const int axis = most.x - least.x < most.y - least.y ? 1 : 0;
    const std::size_t mid = middle(first, end);
    const auto at = [this](std::size_t i) { return order_.begin() + std::ptrdiff_t(i); };
    std::ranges::nth_element(at(first), at(mid), at(end), {},
                             [&](std::uint32_t i) { return points_[i][axis]; });
    axis_[mid] = std::uint8_t(axis);
    left_[mid] = std::uint32_t(end - first);
    divide(first, mid);
    divide(mid + 1, end);
}

void NearestPoints::remove(std::size_t point)
{
    const std::size_t place = place_[point];
    gone_[place] = 1;
    for (std::size_t first = 0, end = order_.size();;) {
        const std::size_t mid = middle(first, end);
        --left_[mid];
        if (mid == place)
            return;
        (place < mid ? end : first) = place < mid ? mid : mid + 1;
    }
}

void NearestPoints::look(std::size_t first, std::size_t end, Search& search) const
{
    const std::size_t mid = middle(first, end);
    if (first == end || left_[mid] == 0)
        return;
    const std::size_t number = order_[mid];
    const Point apart = points_[number] - search.from;
    if (!gone_[mid] && number != search.but && number != search.other) {
        const double distance = std::hypot(apart.x, apart.y);
        if (distance < search.most || (distance == search.most && number < search.found)) {
            search.most = distance;
            search.found = number;
        }
    }
    const double across = apart[axis_[mid]];
    const bool before = across >= 0; // where the search's own point is
    before ? look(first, mid, search) : look(mid + 1, end, search);
    if (std::abs(across) <= search.most)
        before ? look(mid + 1, end, search) : look(first, mid, search);
}

std::optional<NearestPoints::Found> NearestPoints::nearest(std::size_t point, double most,
                                                           std::size_t other) const
{
    Search search{points_[point], point, other, most};
    look(0, order_.size(), search);
    if (search.found >= points_.size())
        return std::nullopt;
    return Found{search.most, search.found};
}

} // namespace app

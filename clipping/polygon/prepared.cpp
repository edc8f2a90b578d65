// SPDX-License-Identifier: MIT
#include "clipping/polygon/prepared.h"

#include "clipping/exact/turn.h"
#include "clipping/frame.h"
#include "clipping/ieee_numbers.h"

#include <algorithm>
#include <cmath>

namespace clipping {
namespace {

struct Corner {
    glm::dvec2 at;
    std::uint32_t number; // of the edge that starts here
};

bool before(const glm::dvec2& p, const glm::dvec2& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }
bool finite(const glm::dvec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// A corner by its place in the order, and the edge from it to the next one in that order.
Corner cornerAt(std::size_t i, std::span<const glm::dvec2> corners, Order order)
{
    if (order == Order::Given)
        return {corners[i], static_cast<std::uint32_t>(i + 1)};
    const std::size_t n = corners.size(), given = n - 1 - i;
    return {corners[given], static_cast<std::uint32_t>(given == 0 ? n : given)};
}

std::vector<Corner> withoutRepeats(std::span<const glm::dvec2> corners, Order order)
{
    std::vector<Corner> all;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner corner = cornerAt(i, corners, order);
        if (all.empty() || all.back().at != corner.at)
            all.push_back(corner);
        else
            all.back() = corner;
    }
    while (all.size() > 1 && all.front().at == all.back().at)
        all.pop_back();
    return all;
}

int turnAt(const std::vector<Corner>& all, std::size_t i)
{
    const std::size_t n = all.size();
    return leftOf(all[i].at, all[(i + 1) % n].at, all[(i + 2) % n].at).sign;
}

/// Whether the direction from p to q is at least 0 and less than 180 degrees.
bool upwards(const glm::dvec2& p, const glm::dvec2& q)
{
    return p.y != q.y ? p.y < q.y : p.x < q.x;
}

/// The outermost two of collinear corners, or the only one.
std::vector<Corner> endsOf(const std::vector<Corner>& all)
{
    const auto [low, high] = std::ranges::minmax_element(
        all, [](const Corner& p, const Corner& q) { return before(p.at, q.at); });
    return low == high ? std::vector{*low} : std::vector{*low, *high};
}

/// The corners at which the polygon turns, starting with the first upward edge; none if it turns
/// right anywhere or goes round more than once. A turn straight back needs no test: a polygon with
/// one that goes round only once is collinear, and collinear polygons are handled before.
std::vector<Corner> turning(const std::vector<Corner>& all)
{
    const std::size_t n = all.size();
    std::vector<Corner> kept;
    std::size_t rounds = 0, first = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto &p = all[(i + n - 1) % n].at, &q = all[i].at, &r = all[(i + 1) % n].at;
        const int turn = turnAt(all, (i + n - 1) % n);
        const bool up = upwards(q, r), wasUp = upwards(p, q);
        if (turn < 0)
            return {};
        if (up && !wasUp)
            ++rounds, first = kept.size();
        if (turn > 0)
            kept.push_back(all[i]);
    }
    if (rounds != 1)
        return {};
    std::rotate(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
    return kept;
}

void measure(PreparedPolygon& polygon)
{
    const auto& corners = polygon.corners;
    polygon.box = {corners[0], corners[0]};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 &from = corners[i], &to = corners[(i + 1) % corners.size()];
        polygon.edges.push_back(to - from);
        polygon.box = {
            glm::dvec2(std::min(polygon.box.min.x, from.x), std::min(polygon.box.min.y, from.y)),
            glm::dvec2(std::max(polygon.box.max.x, from.x), std::max(polygon.box.max.y, from.y))};
        polygon.ordinary = polygon.ordinary && ordinary(Segment{from, to});
    }
}

} // namespace

std::optional<PreparedPolygon> prepared(const ConvexPolygon& polygon)
{
    return prepared(polygon.corners, Order::Given);
}

std::optional<PreparedPolygon> prepared(std::span<const glm::dvec2> given, Order order)
{
    if (given.empty() || !std::ranges::all_of(given, finite))
        return std::nullopt;
    std::vector<Corner> corners = withoutRepeats(given, order);
    bool flat = true;
    for (std::size_t i = 0; flat && i < corners.size(); ++i)
        flat = turnAt(corners, i) == 0;
    corners = flat ? endsOf(corners) : turning(corners);
    if (corners.empty())
        return std::nullopt;
    PreparedPolygon result{
        .corners = {}, .edges = {}, .numbers = {}, .box = {}, .flat = flat, .ordinary = true};
    for (const Corner& corner : corners) {
        result.corners.push_back(corner.at);
        result.numbers.push_back(edgeNumber(corner.number - 1));
    }
    measure(result);
    return result;
}

} // namespace clipping

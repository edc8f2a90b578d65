// SPDX-License-Identifier: MIT
#include "clipping/polygon/edge_table.h"

#include "clipping/exact/line.h"
#include "clipping/ieee_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace clipping {
namespace {

double numberAsBits(std::uint32_t number, int shift)
{
    return std::bit_cast<double>(static_cast<std::uint64_t>(number) << shift);
}

/// Half sides of a rectangle around a centre that encloses the corners, and their lengths' sum.
struct Enclosure {
    glm::dvec2 u, v;
    double size;
};

/// With one side along `way`. Both half sides are longer than necessary by 2^-40 of the larger one,
/// far more than all rounding.
Enclosure enclosureAlong(glm::dvec2 way, glm::dvec2 centre, const std::vector<glm::dvec2>& corners)
{
    way /= std::hypot(way.x, way.y);
    double along = 0, across = 0;
    for (const auto& corner : corners) {
        const auto d = corner - centre;
        along = std::max(along, std::abs(d.x * way.x + d.y * way.y));
        across = std::max(across, std::abs(d.x * way.y - d.y * way.x));
    }
    const double more = 0x1p-40 * (along + across);
    along += more, across += more;
    return {along * way, across * glm::dvec2(-way.y, way.x), along + across};
}

/// The smallest of those along an axis or along one of up to 16 edges. A line meets a convex shape
/// with a probability proportional to its perimeter.
Enclosure smallestEnclosure(const PreparedPolygon& polygon, glm::dvec2 centre)
{
    auto best = enclosureAlong({1, 0}, centre, polygon.corners);
    const std::size_t n = polygon.edges.size(), step = (n + 15) / 16;
    for (std::size_t i = 0; i < n; i += step)
        if (const auto other = enclosureAlong(polygon.edges[i], centre, polygon.corners);
            other.size < best.size)
            best = other;
    return best;
}

} // namespace

EdgeTable::EdgeTable(const PreparedPolygon& polygon)
{
    constexpr std::size_t columns = 12;
    const std::size_t size = polygon.corners.size(), room = std::max<std::size_t>(size, 8);
    numbers_.resize(columns * room);
    std::array<double*, columns> column{};
    for (std::size_t i = 0; i < columns; ++i)
        column[i] = numbers_.data() + i * room;
    const auto box = boxOf(polygon.box);
    const double largest =
        std::max({-polygon.box.min.x, polygon.box.max.x, -polygon.box.min.y, polygon.box.max.y});
    bool hasAxisAligned = false;
    for (std::size_t i = 0; i < size; ++i) {
        const auto &from = polygon.corners[i], &to = polygon.corners[(i + 1) % size];
        const auto x = twoDifference(to.x, from.x), y = twoDifference(to.y, from.y);
        const std::array row{from.x,
                             from.y,
                             x.high,
                             x.low,
                             y.high,
                             y.low,
                             numberAsBits(static_cast<std::uint32_t>(i), 0),
                             numberAsBits(polygon.numbers[i], 32),
                             numberAsBits(polygon.numbers[i], 48),
                             2 * largest * (std::abs(x.high) + std::abs(y.high)),
                             from.x - box.centreX,
                             from.y - box.centreY};
        hasAxisAligned = hasAxisAligned || x.high == 0 || y.high == 0;
        for (std::size_t k = 0; k < columns; ++k)
            column[k][i] = row[k];
    }
    const auto [u, v, length] = smallestEnclosure(polygon, {box.centreX, box.centreY});
    const auto up = [](double x) { return x * (1 + 0x1p-50); };
    table_ = {size,
              column[0],
              column[1],
              column[2],
              column[3],
              column[4],
              column[5],
              column[6],
              column[7],
              column[8],
              column[9],
              column[10],
              column[11],
              box,
              u.x,
              u.y,
              v.x,
              v.y,
              up(std::abs(u.x) + std::abs(v.x) + std::abs(box.centreX)),
              up(std::abs(u.y) + std::abs(v.y) + std::abs(box.centreY)),
              hasAxisAligned,
              polygon.namesEveryCut};
}

} // namespace clipping

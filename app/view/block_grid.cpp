// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/block_grid.h"

#include "app/scene/scene_block.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace app {

constexpr double mostCellsPerSide = 512; // more cells cost more to fill than they save
constexpr double mostCellsCrossed = 16;  // by a segment, on average: long segments need fewer cells
constexpr std::size_t ahead = 16;        // segments fetched before they are needed
constexpr double rounding = 1e-12;       // above the rounding errors of positions

static_assert(SceneBlock::mostSegments - 1 <= std::numeric_limits<std::uint16_t>::max());

double distance(const Point& point, const clipping::Segment& s)
{
    const Point along = s.b - s.a;
    const double square = glm::dot(along, along);
    const double t = square > 0 ? std::clamp(glm::dot(point - s.a, along) / square, 0.0, 1.0) : 0;
    return glm::distance(point, s.a + along * t);
}

// Segments that are not finite are near nothing.
static bool hasFiniteEnds(const clipping::Segment& s)
{
    const Point zero = (s.a - s.a) + (s.b - s.b);
    return zero == Point(0);
}

// Whether the segment's box or its infinite line is farther away than `reach`. Cheaper than the
// distance: without division and root.
static bool isBeside(const clipping::Segment& s, const Point& point, const Point& reach)
{
    if (std::max(s.a.x, s.b.x) < point.x - reach.x || std::min(s.a.x, s.b.x) > point.x + reach.x
        || std::max(s.a.y, s.b.y) < point.y - reach.y || std::min(s.a.y, s.b.y) > point.y + reach.y)
        return true;
    const Point along = s.b - s.a, to = point - s.a;
    const double slack = rounding * (std::abs(along.x) + std::abs(along.y));
    const double least = (std::max(reach.x, reach.y) + slack) * (1 + 1e-6);
    const double area = along.x * to.y - along.y * to.x;
    return area * area > least * least * glm::dot(along, along);
}

BlockGrid::BlockGrid(std::span<const clipping::Segment> segments)
{
    lay(segments);
    start_.assign(columns_ * rows_ + 1, 0);
    for (const auto& s : segments)
        visit(s, [&](std::size_t cell) { ++start_[cell + 1]; });
    for (std::size_t i = 1; i < start_.size(); ++i)
        start_[i] += start_[i - 1];
    segments_.resize(start_.back());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < segments.size(); ++i)
        visit(segments[i], [&](std::size_t cell) { segments_[next[cell]++] = std::uint16_t(i); });
}

BlockGrid BlockGrid::ofOneCell(std::size_t segments)
{
    BlockGrid grid;
    grid.start_ = {0, std::uint32_t(segments)};
    grid.segments_.resize(segments);
    std::iota(grid.segments_.begin(), grid.segments_.end(), std::uint16_t(0));
    return grid;
}

bool BlockGrid::findNear(std::span<const clipping::Segment> segments, const Point& point,
                         double radius, std::size_t first, std::vector<std::size_t>& found,
                         NearLimits& limits) const
{
    const auto before = std::ptrdiff_t(found.size());
    const auto tidy = [&] { // a segment is in several cells
        std::sort(found.begin() + before, found.end());
        found.erase(std::unique(found.begin() + before, found.end()), found.end());
        return found.size() <= limits.found;
    };
    std::size_t full = limits.found; // tidying at every number would take long
    const Point reach = radius + (glm::abs(point) + radius) * rounding;
    const Cells cells = cellsOf(point - reach, point + reach);
    for (std::size_t y = cells.y0; y <= cells.y1; ++y)
        for (std::size_t x = cells.x0; x <= cells.x1; ++x) {
            const std::size_t cell = y * columns_ + x;
            const std::size_t looks =
                std::min<std::size_t>(limits.looks, start_[cell + 1] - start_[cell]);
            limits.looks -= looks;
            for (std::size_t i = start_[cell]; i < start_[cell] + looks; ++i) {
                if (i + ahead < segments_.size())
                    __builtin_prefetch(&segments[segments_[i + ahead]]);
                const auto& segment = segments[segments_[i]];
                if (isBeside(segment, point, reach) || !(distance(point, segment) <= radius))
                    continue;
                found.push_back(first + segments_[i]);
                if (found.size() <= full)
                    continue;
                if (!tidy())
                    return false;
                full = found.size() + limits.found;
            }
        }
    return tidy();
}

// Chooses the cell size: long segments need fewer cells.
void BlockGrid::lay(std::span<const clipping::Segment> segments)
{
    std::optional<clipping::Window> all;
    for (const auto& s : segments) {
        if (!hasFiniteEnds(s))
            continue;
        const Point min = glm::min(s.a, s.b), max = glm::max(s.a, s.b);
        all = all ? clipping::Window{glm::min(all->min, min), glm::max(all->max, max)}
                  : clipping::Window{min, max};
    }
    if (!all)
        return;
    const auto& [min, max] = *all;
    Point share(0); // the sum of all segments as shares of the total width and height
    for (const auto& s : segments)
        if (hasFiniteEnds(s))
            share += glm::abs(s.b - s.a) / glm::max(max - min, Point(1e-12));
    const auto count = double(segments.size());
    const double crossed = mostCellsCrossed * count / std::max(share.x + share.y, 1.0);
    const double side = std::clamp(std::min(std::sqrt(count) / 2, crossed), 1.0, mostCellsPerSide);
    origin_ = min;
    columns_ = rows_ = std::size_t(side);
    cell_ = glm::max((max - min) / double(columns_), Point(1e-12));
}

BlockGrid::Cells BlockGrid::cellsOf(const Point& min, const Point& max) const
{
    const auto index = [](double v, std::size_t count) {
        return std::size_t(std::clamp(v, 0.0, double(count - 1)));
    };
    const Point from = (min - origin_) / cell_, to = (max - origin_) / cell_;
    return {index(from.x, columns_), index(from.y, rows_), index(to.x, columns_),
            index(to.y, rows_)};
}

// Visits the cells of a segment row by row: in each row, the cells that the segment crosses within
// the row's height.
template <class Visit>
void BlockGrid::visit(const clipping::Segment& s, const Visit& cell) const
{
    if (!hasFiniteEnds(s))
        return;
    const Cells all = cellsOf(glm::min(s.a, s.b), glm::max(s.a, s.b));
    const Point along = s.b - s.a;
    for (std::size_t y = all.y0; y <= all.y1; ++y) {
        Cells row = all;
        if (all.y0 != all.y1 && all.x0 != all.x1) {
            const double top = origin_.y + double(y) * cell_.y;
            const double t0 = std::clamp((top - s.a.y) / along.y, 0.0, 1.0);
            const double t1 = std::clamp((top + cell_.y - s.a.y) / along.y, 0.0, 1.0);
            const double x0 = s.a.x + along.x * t0, x1 = s.a.x + along.x * t1;
            const Point slack = cell_ * 1e-6;
            row = cellsOf({std::min(x0, x1) - slack.x, top}, {std::max(x0, x1) + slack.x, top});
        }
        for (std::size_t x = row.x0; x <= row.x1; ++x)
            cell(y * columns_ + x);
    }
}

} // namespace app

// SPDX-License-Identifier: MIT
#include "clipping/region/grid.h"

#include "clipping/ieee_numbers.h"

#include <glm/common.hpp>

#include <cassert>
#include <numeric>

namespace clipping {
namespace {

/// Turns counts per cell, stored one cell later, into the first index of each cell.
void sumUp(std::vector<std::uint32_t>& counts)
{
    std::partial_sum(counts.begin(), counts.end(), counts.begin());
}

bool isTame(double extent) { return extent == 0 || (extent > 0x1p-400 && extent < 0x1p400); }

/// The numbers of columns and rows for so many cells, as square as possible; fewer for edges that
/// would each be listed in very many cells.
glm::dvec2 partsFor(std::span<const AreaEdge> edges, double wanted, const glm::dvec2& extent)
{
    const auto count = static_cast<double>(edges.size());
    const double cells = std::min(wanted, 0x1p20);
    if (!isTame(extent.x) || !isTame(extent.y))
        return {1, 1}; // `trace` would list every edge nearly everywhere
    const double ratio = extent.x / extent.y;
    const double across = std::clamp(std::sqrt(cells * (ratio > 0 ? ratio : 1)), 1.0, cells);
    const glm::dvec2 parts(across, cells / across);
    const glm::dvec2 size(extent.x > 0 ? extent.x : 1, extent.y > 0 ? extent.y : 1);
    double crossed = 0;
    for (const AreaEdge& edge : edges) {
        const glm::dvec2 share = glm::abs(edge.segment.b - edge.segment.a) / size;
        crossed += share.x * parts.x + share.y * parts.y;
    }
    const double room = 0x1p18 + 4 * count;
    return crossed > room ? parts * (room / crossed) : parts;
}

} // namespace

// With e = 2^-53: `of` errs by 4 e of the extent, `start` by 3 e of it and e of a coordinate; an
// extent is at most twice the largest coordinate, and numbers are up to 2 e of it apart. That is 17
// e of it; the margin is 32 e.
SearchGrid::Axis::Axis(double from, double to, double parts)
    : low(from), high(to), margin(0x1p-48 * std::max(std::abs(from), std::abs(to)))
{
    const double extent = to - from;
    // Each part is far wider than the margin, so that its middle is in it.
    const double most = std::floor(std::min(parts, extent / margin * 0x1p-12));
    if (!std::isfinite(extent) || !(most >= 2) || !(extent >= 0x1p-1000))
        return;
    count = static_cast<std::size_t>(most);
    width = extent / most;
    perUnit = most / extent;
}

SearchGrid::SearchGrid(std::span<const AreaEdge> edges, std::size_t steps, double cellsForEach,
                       double fewest)
{
    if (edges.empty()) {
        firstEdge_.assign(2, 0), firstWinding_.assign(2, 0), edgedBefore_.assign(4, 0);
        return;
    }
    box_ = boxOf(edges);
    // Fewer cells for many areas, as each may have a winding number in each cell.
    const double most = std::max(64.0, 0x1p24 / static_cast<double>(steps));
    const double cells =
        std::min(most, std::max(fewest, cellsForEach * static_cast<double>(edges.size())));
    const glm::dvec2 parts = partsFor(edges, cells, box_.max - box_.min);
    columns_ = Axis(box_.min.x, box_.max.x, parts.x);
    rows_ = Axis(box_.min.y, box_.max.y, parts.y);
    both_.low = Two{columns_.low, rows_.low};
    both_.high = Two{columns_.high, rows_.high};
    both_.perUnit = Two{columns_.perUnit, rows_.perUnit};
    both_.last = Two{static_cast<double>(columns_.count - 1), static_cast<double>(rows_.count - 1)};
    listEdges(edges);
    countEdged();
    findWindings(edges, steps);
}

void SearchGrid::countEdged()
{
    const std::size_t line = columns_.count + 1;
    edgedBefore_.assign(line * (rows_.count + 1), 0);
    for (std::size_t row = 0, cell = 0; row < rows_.count; ++row) {
        std::uint32_t inRow = 0;
        for (std::size_t column = 1; column < line; ++column, ++cell) {
            inRow += firstEdge_[cell] != firstEdge_[cell + 1];
            const std::size_t corner = (row + 1) * line + column;
            edgedBefore_[corner] = edgedBefore_[corner - line] + inRow;
        }
    }
}

void SearchGrid::listEdges(std::span<const AreaEdge> edges)
{
    firstEdge_.assign(cells() + 1, 0);
    for (const AreaEdge& edge : edges)
        trace(edge.segment, [&](std::size_t first, std::size_t last) {
            for (std::size_t cell = first; cell <= last; ++cell)
                ++firstEdge_[cell + 1];
        });
    sumUp(firstEdge_);
    edges_.resize(firstEdge_.back());
    std::vector<std::uint32_t> next(firstEdge_.begin(), firstEdge_.end() - 1);
    for (std::uint32_t i = 0; i < edges.size(); ++i)
        trace(edges[i].segment, [&](std::size_t first, std::size_t last) {
            for (std::size_t cell = first; cell <= last; ++cell)
                edges_[next[cell]++] = i;
        });
}

/// The first column whose reference in that row is on the right of an edge that crosses the row.
std::size_t SearchGrid::firstRightOf(const Segment& edge, std::size_t row) const
{
    const int left = edge.b.y > edge.a.y ? 1 : -1;
    std::size_t from = 0, to = columns_.count;
    while (from < to) {
        const std::size_t at = (from + to) / 2;
        const bool isLeft = reference(row * columns_.count + at).side(edge) == left;
        (isLeft ? from : to) = isLeft ? at + 1 : at;
    }
    return from;
}

std::vector<std::vector<SearchGrid::Crossed>>
SearchGrid::crossedRows(std::span<const AreaEdge> edges) const
{
    std::vector<std::vector<Crossed>> crossed(rows_.count);
    for (const auto& [segment, step, number] : edges) {
        const double low = std::min(segment.a.y, segment.b.y);
        const double high = std::max(segment.a.y, segment.b.y);
        const int up = segment.b.y > segment.a.y ? 1 : -1;
        for (std::size_t row = rows_.of(low); row <= rows_.of(high); ++row) {
            // The reference is infinitely little below its y.
            if (!(low < rows_.middle(row) && rows_.middle(row) <= high))
                continue;
            const std::size_t column = firstRightOf(segment, row);
            crossed[row].push_back({static_cast<std::uint32_t>(column), step, -up});
        }
    }
    return crossed;
}

void SearchGrid::findWindings(std::span<const AreaEdge> edges, std::size_t steps)
{
    firstWinding_.reserve(cells() + 1);
    firstWinding_.push_back(0);
    Windings here(steps);
    for (auto& row : crossedRows(edges)) {
        std::ranges::sort(row, {}, &Crossed::column);
        here.clear();
        auto next = row.begin();
        for (std::size_t column = 0; column < columns_.count; ++column) {
            for (; next != row.end() && next->column == column; ++next)
                here.add(next->step, next->change);
            here.appendTo(windings_);
            firstWinding_.push_back(static_cast<std::uint32_t>(windings_.size()));
        }
    }
}

} // namespace clipping

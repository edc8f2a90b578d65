// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/beside.h"
#include "clipping/region/edges.h"
#include "clipping/region/winding.h"

#include <algorithm>
#include <cmath>

namespace clipping {

/// A grid over the edges of a region. Each cell knows the edges that meet it, a reference point,
/// and the winding numbers there.
///
/// A coordinate belongs to exactly one column or row, by a monotone function. Where lines are
/// traced through the grid, margins larger than all rounding make the traced columns a superset:
/// wherever an edge and a segment meet, a traced cell of the segment lists the edge.
class SearchGrid {
public:
    /// A rectangle of cells.
    struct Block {
        std::size_t left, right, bottom, top; ///< columns and rows, all of them included
    };

    /// With about so many cells for each edge, and at least `fewest`.
    SearchGrid(std::span<const AreaEdge> edges, std::size_t steps, double cellsForEach,
               double fewest);

    const Window& box() const { return box_; }
    std::size_t cells() const { return columns_.count * rows_.count; }
    std::size_t cellOf(const glm::dvec2& p) const
    {
        return rows_.of(p.y) * columns_.count + columns_.of(p.x);
    }
    /// The cells that the bounding box of a segment meets, the nearest ones if it is off the grid:
    /// wherever an edge meets the segment, one of them lists the edge. Any cells for a segment with
    /// a number that is not finite.
    Block blockOf(const Segment& s) const;
    std::size_t firstIn(const Block& block) const
    {
        return block.bottom * columns_.count + block.left;
    }
    /// Whether a cell of the block lists an edge.
    bool hasEdges(const Block& block) const
    {
        const std::size_t line = columns_.count + 1;
        const std::uint32_t* below = &edgedBefore_[block.bottom * line];
        const std::uint32_t* above = &edgedBefore_[(block.top + 1) * line];
        return above[block.right + 1] - above[block.left]
               != below[block.right + 1] - below[block.left];
    }
    /// Indices of the edges that meet the cells from `first` to `last`, cell after cell.
    std::span<const std::uint32_t> edgesIn(std::size_t first, std::size_t last) const
    {
        const std::uint32_t begin = firstEdge_[first];
        return std::span(edges_).subspan(begin, firstEdge_[last + 1] - begin);
    }
    std::size_t listed() const { return edges_.size(); } ///< edges, in all cells together
    std::span<const Winding> windingsIn(std::size_t cell) const
    {
        return std::span(windings_).subspan(firstWinding_[cell],
                                            firstWinding_[cell + 1] - firstWinding_[cell]);
    }
    Reference reference(std::size_t cell) const
    {
        return {{columns_.middle(cell % columns_.count), rows_.middle(cell / columns_.count)}};
    }

    /// Calls `visit(first, last)` with ranges of neighbouring cells that together contain the part
    /// of the segment inside the box. The segment's own box must meet the grid's.
    template <class Visit>
    void trace(const Segment& s, Visit&& visit) const;

    /// The same for a box.
    template <class Visit>
    void trace(const Window& box, Visit&& visit) const
    {
        const std::size_t left = columns_.of(box.min.x), right = columns_.of(box.max.x);
        for (std::size_t row = rows_.of(box.min.y); row <= rows_.of(box.max.y); ++row)
            visit(row * columns_.count + left, row * columns_.count + right);
    }

private:
    /// One axis: [low, high] in equal parts.
    struct Axis {
        double low = 0, high = 0, perUnit = 0, width = 0, margin = 0;
        std::size_t count = 1;

        Axis() = default;
        Axis(double from, double to, double parts);
        std::size_t of(double x) const
        {
            // Without branches, which would often be mispredicted.
            const double above = low > x ? low : x, inside = high < above ? high : above;
            // By way of int, to which processors convert fast.
            const auto part = static_cast<int>((inside - low) * perUnit);
            return std::min(static_cast<std::size_t>(part), count - 1);
        }
        double start(std::size_t i) const { return low + static_cast<int>(i) * width; }
        /// A coordinate within part i.
        double middle(std::size_t i) const
        {
            return count == 1 ? low : low + (static_cast<double>(i) + 0.5) * width;
        }
    };

    /// An edge crosses the horizontal line through the references of a row: from `column` on, the
    /// winding number of its area changes by `change`.
    struct Crossed {
        std::uint32_t column, step;
        int change;
    };

    /// Both axes together, for vectors of two numbers.
    using Two [[gnu::vector_size(2 * sizeof(double))]] = double;
    struct BothAxes {
        Two low, high, perUnit, last; ///< last: the number of the last part
    };

    void listEdges(std::span<const AreaEdge> edges);
    void countEdged();
    std::size_t firstRightOf(const Segment& edge, std::size_t row) const;
    std::vector<std::vector<Crossed>> crossedRows(std::span<const AreaEdge> edges) const;
    void findWindings(std::span<const AreaEdge> edges, std::size_t steps);

    Window box_;
    Axis columns_, rows_;
    BothAxes both_{};
    std::vector<std::uint32_t> firstEdge_, edges_;
    /// For each corner of a cell, the number of cells with edges to the left of it and below.
    std::vector<std::uint32_t> edgedBefore_;
    std::vector<std::uint32_t> firstWinding_;
    std::vector<Winding> windings_;
};

inline SearchGrid::Block SearchGrid::blockOf(const Segment& s) const
{
    const auto& [low, high, perUnit, last] = both_;
    const auto partsOf = [&](const Two& p) { // as Axis::of
        const Two above = p > low ? p : low, inside = above < high ? above : high;
        const Two part = (inside - low) * perUnit;
        return part < last ? part : last;
    };
    const Two a{s.a.x, s.a.y}, b{s.b.x, s.b.y};
    const Two lower = partsOf(a < b ? a : b), upper = partsOf(a < b ? b : a);
    const auto whole = [](double part) { return static_cast<std::size_t>(static_cast<int>(part)); };
    return {whole(lower[0]), whole(upper[0]), whole(lower[1]), whole(upper[1])};
}

template <class Visit>
void SearchGrid::trace(const Segment& s, Visit&& visit) const
{
    const auto [left, right, bottom, top] = blockOf(s);
    const auto visitAll = [&, first = left, last = right] {
        for (std::size_t row = bottom; row <= top; ++row)
            visit(row * columns_.count + first, row * columns_.count + last);
    };
    if (right - left < 2 || bottom == top)
        return visitAll();
    const bool up = s.a.y <= s.b.y;
    const glm::dvec2 &from = up ? s.a : s.b, &to = up ? s.b : s.a;
    const double slope = (to.x - from.x) / (to.y - from.y);
    const double reach = std::max(std::abs(from.x), std::abs(to.x));
    // Whether nothing of what follows overflows or underflows.
    const bool isTame = std::abs(slope) > 0x1p-900 && std::abs(slope) < 0x1p900 && reach > 0x1p-900
                        && std::isfinite(to.y - from.y);
    if (!isTame)
        return visitAll();
    // In the lower and upper row the segment's own ends limit it. Between them, x is off by at most
    // 11 e times the larger |x|; rows begin within a margin, which is moved along the slope.
    const double margin = 0x1p-48 * reach + rows_.margin * std::abs(slope);
    double x = from.x;
    if (from.y < rows_.start(bottom))
        x += (rows_.start(bottom) - from.y) * slope;
    for (std::size_t row = bottom; row <= top; ++row) {
        const double end = rows_.start(row + 1);
        const double next = end < to.y ? from.x + (end - from.y) * slope : to.x;
        const double low = std::min(x, next) - margin, high = std::max(x, next) + margin;
        x = next;
        if (high < box_.min.x || low > box_.max.x)
            continue;
        const std::size_t first = std::max(left, columns_.of(low));
        visit(row * columns_.count + first,
              row * columns_.count + std::min(right, columns_.of(high)));
    }
}

} // namespace clipping

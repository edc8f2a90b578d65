// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/beside.h"
#include "clipping/region/edges.h"

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
    /// A winding number other than 0 of one area.
    struct Winding {
        std::uint32_t step;
        int number;
    };

    SearchGrid(std::span<const AreaEdge> edges, std::size_t steps);

    const Window& box() const { return box_; }
    std::size_t cells() const { return columns_.count * rows_.count; }
    std::size_t cellOf(const glm::dvec2& p) const
    {
        return rows_.of(p.y) * columns_.count + columns_.of(p.x);
    }
    bool hasEdges(std::size_t cell) const { return firstEdge_[cell] != firstEdge_[cell + 1]; }
    /// Indices of the edges that meet the cells from `first` to `last`, cell after cell.
    std::span<const std::uint32_t> edgesIn(std::size_t first, std::size_t last) const
    {
        const std::uint32_t begin = firstEdge_[first];
        return std::span(edges_).subspan(begin, firstEdge_[last + 1] - begin);
    }
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

    void listEdges(std::span<const AreaEdge> edges);
    std::size_t firstRightOf(const Segment& edge, std::size_t row) const;
    std::vector<std::vector<Crossed>> crossedRows(std::span<const AreaEdge> edges) const;
    void findWindings(std::span<const AreaEdge> edges, std::size_t steps);

    Window box_;
    Axis columns_, rows_;
    std::vector<std::uint32_t> firstEdge_, edges_;
    std::vector<std::uint32_t> firstWinding_;
    std::vector<Winding> windings_;
};

template <class Visit>
void SearchGrid::trace(const Segment& s, Visit&& visit) const
{
    const bool up = s.a.y <= s.b.y;
    const glm::dvec2 &from = up ? s.a : s.b, &to = up ? s.b : s.a;
    const std::size_t left = columns_.of(std::min(from.x, to.x));
    const std::size_t right = columns_.of(std::max(from.x, to.x));
    const std::size_t bottom = rows_.of(from.y), top = rows_.of(to.y);
    const double slope = (to.x - from.x) / (to.y - from.y);
    const double reach = std::max(std::abs(from.x), std::abs(to.x));
    // Whether nothing of what follows overflows or underflows.
    const bool isTame = std::abs(slope) > 0x1p-900 && std::abs(slope) < 0x1p900 && reach > 0x1p-900
                        && std::isfinite(to.y - from.y);
    if (right - left < 2 || bottom == top || !isTame) {
        for (std::size_t row = bottom; row <= top; ++row)
            visit(row * columns_.count + left, row * columns_.count + right);
        return;
    }
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

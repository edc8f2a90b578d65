// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"
#include "app/cost_map/measure.h"
#include "app/document/subpath.h"

#include <optional>
#include <vector>

// The cost of a line with one end at a fixed point, for every place of the other end.

namespace app {

/// Which end of the line is fixed; the other one moves over the plane.
enum class FixedEnd : std::uint8_t { End1, End2 };

/// What a cost map shows.
struct CostPlan {
    std::optional<Variant> shown{}; ///< whose cost; empty: the map of the cheapest variants
    std::vector<Variant> variants;  ///< the candidates for the cheapest; at most 32
    const CostMeasure* measure;     ///< never null
    Point fixed;
    FixedEnd end = FixedEnd::End1;
    clipping::Window window;
    clipping::Window area;     ///< of the plane; not empty
    int columns = 1, rows = 1; ///< cells across the area; rows begin at area.min.y

    std::size_t cells() const { return std::size_t(columns) * std::size_t(rows); }
    /// The middle of a cell: the moving end of the cell's line.
    Point middleOf(int column, int row) const;
    /// The line with that moving end, from End 1 to End 2.
    clipping::Segment lineTo(const Point& end) const;

    friend bool operator==(const CostPlan&, const CostPlan&) = default;
};

/// All algorithms of the catalogue that have this form.
std::vector<Variant> costVariants(clipping::Form form);
/// A plan for MD and all operations, with the fixed end left of the window, in areaAround(window).
CostPlan usualCostPlan(const clipping::Window& window);
/// The plane around a window: three times as wide and as high. A window without extent is given
/// one.
clipping::Window areaAround(const clipping::Window& window);

/// The cost of one line: counts are those of `clipping::Functions::count`. Time: nanoseconds of the
/// thread's processor time a line, the median of some rounds that each clip the line many times.
/// The time is noisy, and shorter than among other lines, because the processor predicts the
/// branches.
double costOf(const Variant& variant, const CostMeasure& measure, const clipping::Segment& line,
              const clipping::Window& window);

/// The costs, cell by cell, row by row. While it grows it holds the first cells.
struct CostMap {
    CostPlan plan;
    std::vector<float> values{};           ///< the cost; in a map of the cheapest: the least cost
    std::vector<std::uint32_t> cheapest{}; ///< bit n is variant n; several bits: a tie

    bool complete() const { return values.size() == plan.cells(); }
    std::size_t at(int column, int row) const
    {
        return std::size_t(row) * std::size_t(plan.columns) + std::size_t(column);
    }
};

/// Computes that many more cells. Times within a tenth of the least are a tie.
CostMap extended(CostMap so, std::size_t cells);
/// Computes the whole map.
CostMap costMap(CostPlan plan);

/// The variants that are cheapest for one line, and their cost.
struct Cheapest {
    std::uint32_t which;
    double cost;
};
Cheapest cheapestOf(const CostPlan& plan, const clipping::Segment& line);

} // namespace app

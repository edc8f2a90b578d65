// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"
#include "app/cost_map/measure.h"
#include "app/document/subpath.h"

#include <optional>
#include <vector>

// What a line costs that has one end at a fixed point, for every place of the other end.

namespace app {

/// Which end of the line stays; the other one sweeps the plane.
enum class FixedEnd : std::uint8_t { End1, End2 };

/// What a cost map shows.
struct CostPlan {
    std::optional<Variant> shown{};   ///< whose cost; nothing: which variant is the cheapest
    std::vector<Variant> variants;    ///< that are asked which is cheapest; at most 32
    const CostMeasure* measure;       ///< never null
    Point fixed;
    FixedEnd end = FixedEnd::End1;
    clipping::Window window;
    clipping::Window area;     ///< of the plane; not empty
    int columns = 1, rows = 1; ///< cells across the area; rows begin at area.min.y

    std::size_t cells() const { return std::size_t(columns) * std::size_t(rows); }
    /// The middle of a cell: where its line ends.
    Point middleOf(int column, int row) const;
    /// The line that ends there, from End 1 to End 2.
    clipping::Segment lineTo(const Point& end) const;

    friend bool operator==(const CostPlan&, const CostPlan&) = default;
};

/// All rows of the catalogue in one form, without those that do not have it.
std::vector<Variant> costVariants(clipping::Form form);
/// Whether it can be measured so: arithmetic is not counted in exhibits.
bool canMeasure(const Variant& variant, const CostMeasure& measure);
/// A plan of MD, of all operations, with an end left of the window and three windows of plane.
CostPlan usualCostPlan(const clipping::Window& window);
/// The plane around a window: three times as wide and as high. A window without extent gets some.
clipping::Window areaAround(const clipping::Window& window);

/// Of one line: counts are those of `clipping::Uses::count`. Time: nanoseconds of the thread's
/// processor time a line, the median of some rounds that each clip the line many times over: what
/// is measured is noisy, and shorter than among other lines, because the processor foresees it.
double costOf(const Variant& variant, const CostMeasure& measure, const clipping::Segment& line,
              const clipping::Window& window);

/// Cell by cell, row by row. While it grows it holds the first cells.
struct CostMap {
    CostPlan plan;
    std::vector<float> values{};           ///< the cost; of a map of the cheapest: the least one
    std::vector<std::uint32_t> cheapest{}; ///< there: bit n is variant n. Several bits: a tie

    bool complete() const { return values.size() == plan.cells(); }
    std::size_t at(int column, int row) const
    {
        return std::size_t(row) * std::size_t(plan.columns) + std::size_t(column);
    }
};

/// Computes so many cells more. Times within a tenth of the least are a tie.
CostMap extended(CostMap so, std::size_t cells);
/// All of it.
CostMap costMap(CostPlan plan);

/// The variants that are cheapest for one line, and their cost.
struct Cheapest {
    std::uint32_t which;
    double cost;
};
Cheapest cheapestOf(const CostPlan& plan, const clipping::Segment& line);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/regions.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <optional>

namespace app {

namespace {

/// Which cells are alike, and their distance from cells of another kind.
class Field {
public:
    using Step = std::array<int, 2>;

    explicit Field(const CostMap& map) : map_(map), columns_(map.plan.columns), rows_(map.plan.rows)
    {
        reach_.resize(map.plan.cells());
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column)
                reach_[map.at(column, row)] =
                    reachFrom(column, row, {{{-1, 0}, {-1, -1}, {0, -1}, {1, -1}}});
        for (int row = rows_ - 1; row >= 0; --row)
            for (int column = columns_ - 1; column >= 0; --column) {
                int& here = reach_[map.at(column, row)];
                here = std::min(here, reachFrom(column, row, {{{1, 0}, {1, 1}, {0, 1}, {-1, 1}}}));
            }
    }

    bool alike(std::size_t one, std::size_t other) const
    {
        return map_.cheapest.empty() ? map_.values[one] == map_.values[other]
                                     : map_.cheapest[one] == map_.cheapest[other];
    }
    /// The cell one step away; empty beyond the map's edge or if it is of another kind.
    std::optional<std::size_t> alikeBeside(std::size_t cell, const Step& step) const
    {
        const int column = int(cell) % columns_ + step[0], row = int(cell) / columns_ + step[1];
        if (!has(column, row) || !alike(cell, map_.at(column, row)))
            return std::nullopt;
        return map_.at(column, row);
    }
    int reach(std::size_t cell) const { return reach_[cell]; }

private:
    /// The least value of the neighbours plus 1; 0 beside another kind or the map's edge.
    int reachFrom(int column, int row, const std::array<Step, 4>& steps) const
    {
        const std::size_t here = map_.at(column, row);
        int least = std::numeric_limits<int>::max() - 1;
        for (const auto& [right, down] : steps) {
            if (!has(column + right, row + down))
                return 0;
            const std::size_t there = map_.at(column + right, row + down);
            least = std::min(least, alike(here, there) ? reach_[there] : -1);
        }
        return least + 1;
    }

    bool has(int column, int row) const
    {
        return column >= 0 && row >= 0 && column < columns_ && row < rows_;
    }

    const CostMap& map_;
    int columns_, rows_;
    std::vector<int> reach_;
};

/// The region of these cells. Of the deepest cells, it names the one nearest to their middle.
CostRegion summary(const std::vector<std::size_t>& cells, const CostMap& map, const Field& field)
{
    CostRegion region{.cells = cells.size()};
    for (const std::size_t cell : cells)
        region.reach = std::max(region.reach, field.reach(cell));
    const auto at = [&](std::size_t cell) {
        return Point(int(cell) % map.plan.columns, int(cell) / map.plan.columns);
    };
    Point sum(0), best(-1);
    double count = 0;
    for (const std::size_t cell : cells)
        if (field.reach(cell) == region.reach)
            sum += at(cell), ++count;
    const Point middle = sum / count;
    for (const std::size_t cell : cells)
        if (field.reach(cell) == region.reach
            && (best.x < 0 || glm::distance(at(cell), middle) < glm::distance(best, middle)))
            best = at(cell);
    region.column = int(best.x);
    region.row = int(best.y);
    return region;
}

/// The region that contains a cell.
CostRegion regionFrom(std::size_t first, const CostMap& map, const Field& field,
                      std::vector<bool>& seen)
{
    std::vector<std::size_t> all{first}; // the first ones have been expanded
    seen[first] = true;
    for (std::size_t next = 0; next < all.size(); ++next) {
        for (const Field::Step& step :
             std::array<Field::Step, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
            const auto there = field.alikeBeside(all[next], step);
            if (!there || seen[*there])
                continue;
            seen[*there] = true;
            all.push_back(*there);
        }
    }
    return summary(all, map, field);
}

} // namespace

std::vector<CostRegion> regionsOf(const CostMap& map)
{
    assert(map.complete());
    const Field field(map);
    std::vector<bool> seen(map.plan.cells());
    std::vector<CostRegion> regions;
    for (std::size_t cell = 0; cell < seen.size(); ++cell)
        if (!seen[cell])
            regions.push_back(regionFrom(cell, map, field, seen));
    return regions;
}

} // namespace app

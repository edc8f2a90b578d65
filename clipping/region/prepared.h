// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/edge_tree.h"
#include "clipping/region/fold.h"
#include "clipping/region/grid.h"

#include <atomic>
#include <memory>
#include <mutex>

namespace clipping {

struct ConvexRegion;

/// The edges of a region in a search grid, and what the region keeps between them.
struct RegionGrid : SearchGrid {
    RegionGrid(const PreparedRegion::Data& region, double cellsForEach, double fewest);

    std::vector<std::uint8_t> keepsReference; ///< for each cell, whether its reference is kept
};

/// A region with its edges ordered and in a grid, so that lines are clipped fast.
struct PreparedRegion::Data {
    explicit Data(const Region& region);

    RegionFold fold;
    std::vector<FillRule> rules; ///< of the steps' areas
    std::vector<AreaEdge> edges; ///< ordered by number
    bool isFinite = true;        ///< whether all numbers are
    bool keepsNone;              ///< whether points in no area are kept
    RegionGrid grid;
    std::shared_ptr<const ConvexRegion> convex; ///< null unless it is one (convex.h)

    bool fills(std::uint32_t step, int winding) const
    {
        return rules[step] == FillRule::NonZero ? winding != 0 : (winding & 1) != 0;
    }
    /// The grid for clipping so many segments. Many pay for one with smaller cells, which most
    /// short segments pass without meeting an edge; the first call makes it.
    const RegionGrid& gridFor(std::size_t segments) const;
    /// A tree of the edges, once grids have listed so many too many that it would have been made in
    /// the time; null before. Says that they have listed some more.
    const EdgeTree* treeAfter(std::size_t listedTooMany) const;

private:
    mutable std::mutex making_;
    mutable std::unique_ptr<const RegionGrid> fine_;
    mutable std::unique_ptr<const EdgeTree> tree_;
    mutable std::atomic<const EdgeTree*> madeTree_ = nullptr;
    mutable std::atomic<std::size_t> listedTooMany_ = 0;
};

} // namespace clipping

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/region/prepared.h"

#include <algorithm>

#include "tests/clipping/same_bits.h"

/// The region prepared so that edges are searched in a tree of them at once, not only after the
/// grid has listed very many; in the grid if there can be no tree.
inline clipping::PreparedRegion inTree(const clipping::Region& region)
{
    constexpr std::size_t veryMany = ~std::size_t(0);
    clipping::PreparedRegion prepared(region);
    prepared.data().treeAfter(veryMany);
    return prepared;
}

/// The same pieces, bit for bit.
inline bool arePieces(const std::vector<clipping::RegionPiece>& p,
                      const std::vector<clipping::RegionPiece>& q)
{
    return std::ranges::equal(p, q, [](const auto& a, const auto& b) {
        return sameBits(a.segment, b.segment) && a.edgeOfA == b.edgeOfA && a.edgeOfB == b.edgeOfB;
    });
}

// SPDX-License-Identifier: MIT
#include "clipping/region/edge_tree.h"

#include "clipping/ieee_numbers.h"

#include <utility>

namespace clipping {

bool EdgeTree::suits(const Window& box)
{
    const glm::dvec2 extent = box.max - box.min;
    const double larger = std::max(extent.x, extent.y);
    return larger > 0x1p-400 && larger < 0x1p400;
}

EdgeTree::EdgeTree(std::span<const AreaEdge> edges, std::size_t steps, const Window& box,
                   std::size_t smallLeaf)
    : margin_(0x1p-46 * (box.max.x - box.min.x + box.max.y - box.min.y))
{
    divide(edges, steps, smallLeaf);
    findWindings(edges, steps, box);
}

/// Goes from anchor to anchor. Consecutive ones are in one cell of the tree, mostly a small one.
void EdgeTree::findWindings(std::span<const AreaEdge> edges, std::size_t steps, const Window& box)
{
    Windings here(steps);
    std::vector<std::uint32_t> lastPath(edges.size(), 0); // on which each edge was met
    std::uint32_t number = 1;
    Reference from{box.min}; // which is moved outside, where all numbers are 0
    for (const glm::dvec2& at : anchors_) {
        const Reference to{at};
        const PathBetween path{from, to};
        if (from.at != at)
            trace({from.at, at}, [&](std::span<const std::uint32_t> near) {
                for (const std::uint32_t i : near)
                    if (std::exchange(lastPath[i], number) != number)
                        here.add(edges[i].step, windingStep(edges[i].segment, path));
            });
        here.appendTo(windings_);
        ++number;
        firstWinding_.push_back(static_cast<std::uint32_t>(windings_.size()));
        from = to;
    }
}

EdgeTree::Anchor EdgeTree::anchorNear(const glm::dvec2& p) const
{
    std::uint32_t child = root_;
    while (!(child & leafBit)) {
        const auto& [line, children] = nodes_[child];
        const glm::dvec2 along = (p - line.at) * line.normal;
        child = children[along.x + along.y < 0 ? 1 : 0];
    }
    const std::uint32_t anchor = anchorOf_[child & ~leafBit];
    return {{anchors_[anchor]},
            std::span(windings_).subspan(firstWinding_[anchor],
                                         firstWinding_[anchor + 1] - firstWinding_[anchor])};
}

} // namespace clipping

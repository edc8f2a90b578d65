// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <cstdint>
#include <span>
#include <vector>

namespace app {

/// Finds the boxes that meet another one: a packed tree (sort-tile-recursive), built once.
class BoxIndex {
public:
    BoxIndex() = default;
    explicit BoxIndex(std::span<const clipping::Window> boxes);

    /// Calls visit(number) for each box from number `first` on that has a point in common with
    /// `box`, in any order.
    template <class Visit>
    void meeting(const clipping::Window& box, std::uint32_t first, const Visit& visit) const
    {
        if (!levels_.empty())
            descend(levels_.size() - 1, 0, levels_.back().size(), box, first, visit);
    }

private:
    static constexpr std::size_t fanOut = 8;
    /// A box with its number, or the box around some of them with the largest number.
    struct Node {
        clipping::Window box;
        std::uint32_t number;
    };

    template <class Visit>
    void descend(std::size_t level, std::size_t from, std::size_t end, const clipping::Window& box,
                 std::uint32_t first, const Visit& visit) const
    {
        for (std::size_t i = from; i < end; ++i) {
            const auto& [around, number] = levels_[level][i];
            if (number < first || around.min.x > box.max.x || around.max.x < box.min.x
                || around.min.y > box.max.y || around.max.y < box.min.y)
                continue;
            if (level == 0)
                visit(number);
            else
                descend(level - 1, i * fanOut,
                        std::min((i + 1) * fanOut, levels_[level - 1].size()), box, first, visit);
        }
    }

    std::vector<std::vector<Node>> levels_; ///< the boxes themselves first
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/box_index.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {

BoxIndex::BoxIndex(std::span<const clipping::Window> boxes)
{
    if (boxes.empty())
        return;
    std::vector<Node>& all = levels_.emplace_back();
    for (std::size_t i = 0; i < boxes.size(); ++i)
        all.push_back({boxes[i], std::uint32_t(i)});
    const auto centre = [](const Node& node, glm::length_t axis) {
        return node.box.min[axis] / 2 + node.box.max[axis] / 2;
    };
    const auto along = [&](glm::length_t axis) {
        return [=](const Node& a, const Node& b) { return centre(a, axis) < centre(b, axis); };
    };
    std::ranges::sort(all, along(0));
    const double leaves = std::ceil(double(all.size()) / fanOut);
    const auto strip = std::size_t(std::ceil(std::sqrt(leaves))) * fanOut;
    for (std::size_t from = 0; from < all.size(); from += strip)
        std::ranges::sort(std::span(all).subspan(from, std::min(strip, all.size() - from)),
                          along(1));
    while (levels_.back().size() > fanOut) {
        std::vector<Node> above;
        const std::vector<Node>& below = levels_.back();
        for (std::size_t i = 0; i < below.size(); ++i) {
            if (i % fanOut == 0)
                above.push_back(below[i]);
            Node& around = above.back();
            around.box = {glm::min(around.box.min, below[i].box.min),
                          glm::max(around.box.max, below[i].box.max)};
            around.number = std::max(around.number, below[i].number);
        }
        levels_.push_back(std::move(above));
    }
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/siblings.h"

#include <unordered_map>

namespace app::svg {

const Siblings::Position& Siblings::of(Node node)
{
    if (positions_.empty())
        findOut();
    return positions_[node];
}

void Siblings::findOut()
{
    positions_.resize(tree_.size());
    for (Node parent = 0; parent < tree_.size(); ++parent) {
        if (tree_.end(parent) == parent + 1)
            continue;
        std::unordered_map<std::string_view, std::uint32_t> ofType;
        std::uint32_t count = 0;
        Node previous = noNode;
        for (const Node child : Children(tree_, parent)) {
            if (tree_.name(child) == textNode)
                continue;
            positions_[child] = {++count, 0, ++ofType[tree_.name(child)], 0, previous};
            previous = child;
        }
        for (Node child = previous; child != noNode; child = positions_[child].previous) {
            positions_[child].count = count;
            positions_[child].countOfType = ofType[tree_.name(child)];
        }
    }
}

} // namespace app::svg

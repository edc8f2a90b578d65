// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/kinds.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace app {

std::span<const SnapKind> snapKinds()
{
    // THE CATALOGUE. To add a kind: write its function, declare it in kinds.h, and add its row
    // here.
    static const std::array all{ends(),          middles(),   centres(),     intersections(),
                                perpendicular(), onPath(),    windowEdges(), pageEdges(),
                                axes(),          guideKind(), gridKind(),    alignmentKind(),
                                drawnAlignment()};
    return all;
}

const SnapKind& snapKind(std::string_view key)
{
    const auto found = std::ranges::find(snapKinds(), key, &SnapKind::key);
    assert(found != snapKinds().end());
    return *found;
}

} // namespace app

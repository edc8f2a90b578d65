// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/box_remains.h"

#include "app/base/finite.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace app {
namespace {

/// A faster `remainsOf` for a region of one finite window.
class OneWindow {
public:
    OneWindow(const clipping::Window& window, Keep keep) : window_(window)
    {
        if (keep == Keep::Outside)
            std::swap(remains_[1], remains_[2]);
    }
    // Branch-free, as branches here would be unpredictable. NaNs are neither inside nor outside.
    Remains operator()(const FloatBox& box) const
    {
        const auto& [min, max] = window_;
        const int outside = int(box.maxX < min.x) | int(box.minX > max.x) | int(box.maxY < min.y)
                            | int(box.minY > max.y);
        const int inside = int(box.minX >= min.x) & int(box.maxX <= max.x) & int(box.minY >= min.y)
                           & int(box.maxY <= max.y);
        return remains_[std::size_t(2 * outside + inside)];
    }

private:
    clipping::Window window_;
    // Neither, inside, outside; the fourth case cannot occur.
    std::array<Remains, 4> remains_{Remains::Pieces, Remains::Whole, Remains::Gone,
                                    Remains::Pieces};
};

template <class RemainsOfBox>
void find(const SceneBlock& block, const RemainsOfBox& remainsOfBox, std::span<Remains> remains)
{
    for (const FloatBox& box : block.boxes) {
        const std::size_t first = block.chunks.size() - remains.size();
        const auto here = remains.first(std::min(SceneBlock::chunksInBox, remains.size()));
        remains = remains.subspan(here.size());
        const Remains all = remainsOfBox(box);
        for (std::size_t i = 0; i < here.size(); ++i)
            here[i] = all != Remains::Pieces ? all : remainsOfBox(block.chunks[first + i].box);
    }
}

} // namespace

void findRemains(const SceneBlock& block, const ClipRegion& region, std::span<Remains> remains)
{
    assert(remains.size() == block.chunks.size());
    if (const auto window = region.single(); window && isFinite(*window))
        find(block, OneWindow(*window, region.keep), remains);
    else
        find(
            block, [&](const FloatBox& box) { return remainsOf(region, box.window()); }, remains);
}

} // namespace app

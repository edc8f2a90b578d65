// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/paper_scene.h"

namespace app {

void PaperScene::fill(std::span<clipping::Segment> lines)
{
    const auto between = [&](double low, double high) {
        return low + (high - low) * (double(random_() >> 11) * 0x1p-53); // 53 random bits
    };
    const auto& [min, max] = paperSpace;
    for (clipping::Segment& line : lines)
        for (auto* point : {&line.a, &line.b}) {
            point->x = between(min.x, max.x);
            point->y = between(min.y, max.y);
        }
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/paper_scene.h"

namespace app {

void PaperScene::fill(std::span<clipping::Segment> lines)
{
    for (clipping::Segment& line : lines) {
        line.a = random_.in(space_);
        line.b = random_.in(space_);
    }
}

} // namespace app

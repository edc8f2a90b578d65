// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/visible_lines.h"

namespace app {

std::size_t visibleLines(const Frame& frame, Keep keep)
{
    if (keep == Keep::Inside)
        return frame.inside.size();
    std::size_t lines = 0;
    const clipping::Clipped* last = nullptr; // a line may leave a piece on either side
    for (const clipping::Clipped& piece : frame.outside) {
        lines += !last || last->source != piece.source;
        last = &piece;
    }
    return lines;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/stacking.h"

#include <algorithm>
#include <numeric>

namespace ui {

int lowerTabs(std::span<const int> needed, int room)
{
    const int all = std::accumulate(needed.begin(), needed.end(), 0);
    if (needed.empty() || all <= room)
        return 0;
    int below = needed.back();
    int above = all - below;
    for (std::size_t tabs = 2; tabs < needed.size(); ++tabs) {
        const int next = needed[needed.size() - tabs];
        above -= next;
        below = std::max(below, next);
        if (above + below <= room || tabs + 1 == needed.size())
            return int(tabs);
    }
    return 0;
}

} // namespace ui
